// @ts-check
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
  return (
    <section class="sheet" aria-label={strings.drawer}>
      <div class="section-head sheet-head">
        {!bare && <h2>{title}</h2>}
        <IconButton icon="close" label={strings.close} onClick={() => { ui.sheet.value = null; }} />
      </div>
      <div class="sheet-body">{children}</div>
    </section>
  );
}
