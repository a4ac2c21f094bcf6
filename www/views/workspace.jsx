// @ts-check
import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings.js';
import { IconButton } from './button.jsx';

/**
 * A workspace that lies over the board; the page stays drawn beneath.
 * @param {{ title: string, tools?: import('preact').ComponentChildren, onClose: () => void, class: string, busy?: boolean, children: import('preact').ComponentChildren }} props
 */
export function Workspace({ title, tools, onClose, class: extra, busy = false, children }) {
  const ref = useRef(/** @type {HTMLElement | null} */ (null));
  // What had the focus is out of sight now.
  useEffect(() => ref.current?.focus(), []);
  return (
    <main class="workspace">
      <section class={`workspace-body ${extra}`} aria-label={title} aria-busy={busy} ref={ref} tabIndex={-1}>
        <header class="workspace-head">
          <IconButton icon="previous" label={strings.backToPage} onClick={onClose} />
          <h2>{title}</h2>
          {tools}
        </header>
        {children}
      </section>
    </main>
  );
}
