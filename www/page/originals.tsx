/** The photos of the page without a style, over the page: while a key is held, or until the tool is pressed again. */

import { useEffect } from 'preact/hooks';
import { PLAIN } from '../photos/cover.ts';
import { strings } from '../strings/strings.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import type { PageDocument } from '../engine/types.ts';
import type { OwnKeys } from '../ui/action.ts';

export const ORIGINALS_KEYS: OwnKeys = { keys: ['O'], about: strings.keyAbout.originals };

/** Elements in which letters are typed. */
const TYPED = 'input, textarea, select, [contenteditable]';

/** @param props `width` of the page in pixels */
export function Originals({ page, width }: { page: PageDocument; width: number }) {
  const { engine, ui } = useApp();
  useHeldKey();
  if (!ui.originals.value) return null;
  return (
    <div class="originals">
      <Bitmap of={page} by={width} draw={(call) => engine.renderPage({ ...page, style: PLAIN }, width, call)} />
    </div>
  );
}

function useHeldKey() {
  const { ui } = useApp();
  useEffect(() => {
    const ended = new AbortController();
    const { signal } = ended;
    const hide = () => {
      ui.originals.value = false;
    };
    window.addEventListener(
      'keydown',
      ({ key, repeat, target, ctrlKey, metaKey, altKey, defaultPrevented }) => {
        const isMine = key.toUpperCase() === 'O' && !repeat && !ctrlKey && !metaKey && !altKey && !defaultPrevented;
        const isFree = ui.letterKeys.peek() && ui.work.peek() === null && ui.dialog.peek() === null;
        if (isMine && isFree && !(target instanceof Element && target.matches(TYPED))) ui.originals.value = true;
      },
      { signal },
    );
    window.addEventListener('keyup', ({ key }) => key.toUpperCase() === 'O' && hide(), { signal });
    // The key may be released in another window.
    window.addEventListener('blur', hide, { signal });
    return () => ended.abort();
  }, []);
}
