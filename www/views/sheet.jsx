// @ts-check
import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings.js';
import { IconButton } from './button.jsx';
import { useApp } from './context.js';

/**
 * A part of the board on a small screen, below the page.
 * @param {{ title: string, bare?: boolean, children: import('preact').ComponentChildren }} props
 *   `bare`: the content brings its own heading
 */
export function Sheet({ title, bare = false, children }) {
  const { ui } = useApp();
  const ref = useRef(/** @type {HTMLElement | null} */ (null));
  // It comes before the bar that opens it: without this, Tab would go past it.
  useEffect(() => ref.current?.focus({ preventScroll: true }), []);
  return (
    <section class="sheet" aria-label={strings.drawer} ref={ref} tabIndex={-1}>
      <div class="section-head sheet-head">
        {!bare && <h2>{title}</h2>}
        <IconButton icon="close" label={strings.close} onClick={() => { ui.sheet.value = null; }} />
      </div>
      <div class="sheet-body">{children}</div>
    </section>
  );
}
