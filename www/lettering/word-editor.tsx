import { useLayoutEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { focusOn, placed } from './word-hands.ts';
import type { WordBox } from '../engine/types.ts';

/** The core takes no more. */
const MOST = 4000;
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
    area.focus();
    area.select();
    return () => {
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
      maxLength={MOST}
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
