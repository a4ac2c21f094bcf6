import { useEffect, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { ComponentChildren, ComponentType } from 'preact';

type Panel = ComponentType<{ close: () => void; children: ComponentChildren }>;

/** The choices of an animatic, which come when they are first asked for. */
export function LazyAnimatic({ close, children }: { close: () => void; children: ComponentChildren }) {
  const { messages } = useApp();
  const [loaded, setLoaded] = useState(null as { Panel: Panel } | null);
  useEffect(() => {
    import('./animatic-panel.tsx').then(
      ({ AnimaticPanel }) => setLoaded({ Panel: AnimaticPanel }),
      () => {
        close();
        messages.alert(strings.animatic.missing);
      },
    );
  }, []);
  return loaded ? (
    <loaded.Panel close={close}>{children}</loaded.Panel>
  ) : (
    <div class="export" aria-busy="true">
      <div class="export-preview" />
      <div class="export-choices">{children}</div>
    </div>
  );
}
