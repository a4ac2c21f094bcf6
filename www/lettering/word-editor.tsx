import { useLayoutEffect, useRef } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { liftAbove } from './above-keyboard.ts';
import { capitals } from './word-fields.tsx';
import { focusOn, placed } from './word-hands.ts';
import type { WordBox } from '../engine/types.ts';

/** Smaller text could not be read while it is written, in CSS pixels. A word that is too long for its line may be smaller. */
const LEAST = 14;
const LEAST_FOR_WORDS = 10;
/** Minimum width of the field, in CSS pixels. */
const NARROWEST = 110;
/** Room between the text and the outline, in parts of the width: an oval is narrow at the ends. */
const PADS = { balloon: 0.1, caption: 0.05, effect: 0.03 };

/**
 * The field for the text of an item, inside its balloon, which grows with the text. Enter, Escape and a click elsewhere accept
 * the text; Shift+Enter starts a line. Undo restores the text before.
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
    const largest = Math.max(LEAST, box.size * page.clientWidth);
    const fit = () => {
      area.style.fontSize = `${largest}px`;
      const now = lettering.measured(index, area.value || word.text) ?? box;
      // The drawn balloon extends at least over the field.
      const size = [Math.max(box.width, now.width), Math.max(box.height, now.height)] as const;
      grow(area, page, size, PADS[word.kind]);
      // The font of the system may be wider than the font of the balloon, and then words would break.
      for (let text = largest - 1; area.scrollWidth > area.clientWidth && text >= LEAST_FOR_WORDS; text -= 1) {
        area.style.fontSize = `${text}px`;
        grow(area, page, size, PADS[word.kind]);
      }
    };
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

  function end(text: string, byKey: boolean) {
    if (done.current) return;
    done.current = true;
    lettering.write(index, text);
    // After a click elsewhere, the focus is there.
    if (byKey)
      requestAnimationFrame(() => focusOn(`[data-word="${index}"]`, '[data-word]', '.panels > [tabindex="0"]'));
  }

  function press(event: KeyboardEvent & { currentTarget: HTMLTextAreaElement }) {
    event.stopPropagation();
    if (event.isComposing) return;
    if (event.key !== 'Escape' && (event.key !== 'Enter' || event.shiftKey)) return;
    end(event.currentTarget.value, true);
    event.preventDefault();
  }

  return (
    <textarea
      ref={field}
      class="word-editor"
      data-kind={word.kind}
      aria-label={strings.wordText({ name: strings.word({ kind: strings.wordKind[word.kind], text: word.text }) })}
      maxLength={MOST.letters}
      data-capitals={capitals(word)}
      style={{ ...place, '--fill': box.fill, '--ink': box.color }}
      onKeyDown={press}
      onBlur={(event) => end(event.currentTarget.value, false)}
      onClick={(event) => event.stopPropagation()}
      onPointerDown={(event) => event.stopPropagation()}
    >
      {word.text}
    </textarea>
  );
}

/**
 * Sets the size to the size of the balloon and its text. The page limits the size, because the window may end there.
 * @param size of the balloon in page widths
 */
function grow(area: HTMLTextAreaElement, page: HTMLElement, size: readonly [number, number], pad: number) {
  const { style } = area;
  const [wide, high] = size.map((length) => length * page.clientWidth);
  const across = Math.max(NARROWEST, wide);
  Object.assign(style, { width: `${across}px`, height: '0', paddingBlock: '0', margin: '0' });
  style.paddingInline = `${across * pad}px`;
  const text = area.scrollHeight;
  const tall = Math.min(page.clientHeight, Math.max(high, text * (1 + 2 * pad) + 8));
  const border = area.offsetHeight;
  style.height = `${tall}px`;
  style.paddingBlock = `${Math.max(0, (tall - text - border) / 2)}px`;
  const inside = (at: number, length: number, room: number) =>
    Math.max(length / 2 - at, Math.min(0, room - at - length / 2));
  style.marginTop = `${inside(area.offsetTop, tall, page.clientHeight)}px`;
  style.marginLeft = `${inside(area.offsetLeft, across, page.clientWidth)}px`;
}
