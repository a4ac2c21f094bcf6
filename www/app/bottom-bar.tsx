import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { ShuffleButton } from '../page/shuffle-bar.tsx';
import { ActionButton } from '../ui/action-button.tsx';

/** The bottom bar of small screens: Shuffle in the middle, the drawers next to it. */
export function BottomBar() {
  const { window, download } = useApp().actions;
  return (
    <nav class="bottom-bar" aria-label={strings.name}>
      <ActionButton action={window.photos} class="tab" text opens />
      <ActionButton action={window.styles} class="tab" text opens />
      <ShuffleButton />
      <ActionButton action={window.layouts} class="tab" text opens />
      <ActionButton action={window.words} class="tab" text opens />
      <ActionButton action={download.exportPages} class="tab" text />
    </nav>
  );
}
