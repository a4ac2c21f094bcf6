import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

/** The ways to what lies over the board: in the bar above, on a small screen among the styles. */
export function Workspaces() {
  const { designer, explorer } = useApp().actions.window;
  return (
    <>
      <ActionButton action={designer} class="button" text />
      <ActionButton action={explorer} class="button" text />
    </>
  );
}
