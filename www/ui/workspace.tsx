import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from './button.tsx';
import type { ComponentChildren } from 'preact';

/**
 * A workspace above the board. The page stays drawn below it.
 * @param props `title`: its accessible name; `heading`: the visible name of its view, if that differs
 */
export function Workspace({
  title,
  heading = title,
  tools,
  onClose,
  class: extra,
  busy = false,
  children,
}: {
  title: string;
  heading?: string;
  tools?: ComponentChildren;
  onClose: () => void;
  class: string;
  busy?: boolean;
  children: ComponentChildren;
}) {
  const ref = useRef(null as HTMLElement | null);
  // Take the focus, because the focused element is hidden now.
  useEffect(() => ref.current?.focus(), []);
  return (
    <main class="workspace">
      <section class={`workspace-body ${extra}`} aria-label={title} aria-busy={busy} ref={ref} tabIndex={-1}>
        <header class="workspace-head">
          <IconButton icon="previous" label={strings.backToPage} onClick={onClose} />
          <h2>{heading}</h2>
          {tools}
        </header>
        {children}
      </section>
    </main>
  );
}
