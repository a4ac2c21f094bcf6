import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { useLoaded } from '../ui/loaded.ts';
import type { AnimaticProps } from './animatic-panel.tsx';

/** The settings of a video, loaded on first use. */
export function LazyAnimatic({ of, close, children }: AnimaticProps) {
  const { messages } = useApp();
  const loaded = useLoaded(
    () => import('./animatic-panel.tsx'),
    () => {
      close();
      messages.alert(strings.animatic.missing);
    },
  );
  return loaded ? (
    <loaded.AnimaticPanel of={of} close={close}>
      {children}
    </loaded.AnimaticPanel>
  ) : (
    <div class="export" aria-busy="true">
      <div class="export-preview" />
      <div class="export-choices">{children}</div>
    </div>
  );
}
