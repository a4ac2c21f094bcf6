import { useLayoutEffect, useRef } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { liftAbove } from './above-keyboard.ts';
import { focusOn, placed } from './word-hands.ts';
import type { WordBox } from '../engine/types.ts';

/** Smaller text could not be read while it is written, in CSS pixels. */
const LEAST = 14;

/**
 * The text of a word, written where it stands: Enter takes it, Shift with Enter begins a line, Escape leaves it as it was.
 * @param props `height` of the page, in its widths
 */
export function WordEditor({ index, box, height }: { index: number; box: WordBox; height: number }) {
  const { lettering } = useApp();
  const field = useRef(null as HTMLTextAreaElement | null);
  const word = lettering.words.value[index];
  const done = useRef(false);
  const place = placed(box, height);

  useLayoutEffect(() => {
    const area = field.current as HTMLTextAreaElement;
    const page = area.closest('.page') as HTMLElement;
    area.style.fontSize = `${Math.max(LEAST, box.size * page.clientWidth)}px`;
    const fit = () => grow(area, page);
    fit();
    area.addEventListener('input', fit);
    // The focus brings the keyboard of the screen, which makes the window that is seen lower a moment later.
    const lower = liftAbove(area);
    area.focus({ preventScroll: true });
    area.select();
    return () => {
      lower();
      if (lettering.editing.peek() === index) lettering.editing.value = -1;
    };
  }, []);

  /** @param text null leaves it as it was */
  function end(text: string | null, byKey: boolean) {
    if (done.current) return;
    done.current = true;
    if (text === null) lettering.editing.value = -1;
    else lettering.write(index, text);
    // Whoever clicked elsewhere has the focus there.
    if (byKey)
      requestAnimationFrame(() => focusOn(`[data-word="${index}"]`, '[data-word]', '.panels > [tabindex="0"]'));
  }

  function press(event: KeyboardEvent & { currentTarget: HTMLTextAreaElement }) {
    event.stopPropagation();
    if (event.isComposing) return;
    if (event.key === 'Escape') end(null, true);
    else if (event.key === 'Enter' && !event.shiftKey) end(event.currentTarget.value, true);
    else return;
    event.preventDefault();
  }

  return (
    <textarea
      ref={field}
      class="word-editor"
      data-kind={word.kind}
      aria-label={strings.wordText(strings.word(word.kind, word.text))}
      maxLength={MOST.letters}
      // It is wider than a short word, and stays on the page.
      style={{ ...place, left: `clamp(75px, ${place.left}, 100% - 75px)` }}
      onKeyDown={press}
      onBlur={(event) => end(event.currentTarget.value, false)}
      onClick={(event) => event.stopPropagation()}
      onPointerDown={(event) => event.stopPropagation()}
    >
      {word.text}
    </textarea>
  );
}

/** As high as its text is, and not over the edge of the page, where the window may end. */
function grow(area: HTMLTextAreaElement, page: HTMLElement) {
  area.style.minHeight = '';
  area.style.marginTop = '';
  const borders = area.offsetHeight - area.clientHeight;
  const tall = Math.max(area.offsetHeight, area.scrollHeight + borders);
  area.style.minHeight = `${tall}px`;
  const [above, below] = [area.offsetTop - tall / 2, page.clientHeight - area.offsetTop - tall / 2];
  area.style.marginTop = `${Math.max(-above, Math.min(0, below))}px`;
}
