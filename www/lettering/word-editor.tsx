import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { wordName } from '../document/word-names.ts';
import { strings } from '../strings/strings.ts';
import { createTimer } from '../engine/scheduler.ts';
import { useApp } from '../ui/context.ts';
import { liftAbove } from './above-keyboard.ts';
import { capitals } from './word-fields.tsx';
import { fontFamily, loadFont } from './word-fonts.ts';
import { focusOn, placed } from './word-hands.ts';
import type { Word, WordBox } from '../engine/types.ts';

/** Minimum width of the field, in CSS pixels. */
const NARROWEST = 56;
/** Maximum size of the text in the field of a sound effect, and the gap between field and effect, in CSS pixels. */
const MOST_FOR_EFFECTS = 20;
const GAP = 8;
/** Minimum room above and below the text together, in CSS pixels. */
const LEAST_PAD = 8;
/** This space in a balloon, in parts of the height of its text. The round outline would cut the first and last lines. */
const ROUND_PAD = 0.2;
/** Width of the outline of the field, which stays on the page, in CSS pixels. */
const OUTLINE = 3;
/** Pause in typing before a long text gets a new place, in milliseconds. */
const REST = 400;
/** Room between the text and the outline, in parts of the width: an oval is narrow at the ends. */
const PADS = { balloon: 0.1, caption: 0.05, effect: 0.03 };

/**
 * The field for the text of an item, inside its balloon, which grows with the text. The field of a sound effect is below
 * or above the effect, which changes during typing. Enter, Escape and a click elsewhere accept the text; Shift+Enter starts
 * a line. Undo restores the text before.
 * @param props `height` of the page, in its widths
 */
export function WordEditor({ index, box, height }: { index: number; box: WordBox; height: number }) {
  const { lettering } = useApp();
  const field = useRef(null as HTMLTextAreaElement | null);
  const word = lettering.words.value[index];
  const first = useRef(word.text);
  const done = useRef(false);
  // The field moves itself.
  const place = useMemo(() => placed(box, height), []);
  const isEffect = word.kind === 'effect';
  const gesture = useMemo(() => lettering.typingStep(index), []);

  useLayoutEffect(() => {
    const area = field.current as HTMLTextAreaElement;
    const page = area.closest('.page') as HTMLElement;
    const resting = createTimer();
    const fit = (isAtRest = false) => {
      const now = lettering.measured(index, area.value || word.text, isAtRest) ?? box;
      const text = now.size * page.clientWidth;
      const largest = isEffect ? Math.min(MOST_FOR_EFFECTS, text) : text;
      area.style.fontSize = `${largest}px`;
      const { left, top } = placed(now, height);
      Object.assign(area.style, { left, top });
      // The drawn balloon extends at least over the field.
      const size = isEffect
        ? ([now.width, 0] as const)
        : ([Math.max(box.width, now.width), Math.max(box.height, now.height)] as const);
      grow(area, page, size, word.kind);
      if (isEffect) moveBeside(area, page, now);
      // The font of the system may be wider than the font of the balloon, and then words would break.
      for (let text = largest - 1; area.scrollWidth > area.clientWidth && text > largest / 2; text -= 1) {
        area.style.fontSize = `${text}px`;
        grow(area, page, size, word.kind);
      }
    };
    fit();
    area.addEventListener('input', () => {
      fit();
      resting.start(REST, () => fit(true));
    });
    // A keyboard of the screen can make the page smaller.
    const resized = new ResizeObserver(() => fit());
    resized.observe(page);
    void loadFont(box.font).then(() => area.isConnected && fit());
    // The focus brings the keyboard of the screen, which makes the window that is seen lower a moment later.
    const lower = liftAbove(area);
    area.focus({ preventScroll: true });
    area.select();
    return () => {
      resized.disconnect();
      resting.stop();
      lower();
      if (lettering.editing.peek() === index) lettering.editing.value = -1;
    };
  }, []);

  function end(text: string, byKey: boolean) {
    if (done.current) return;
    done.current = true;
    lettering.write(index, text, gesture);
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
      aria-label={strings.wordText({ name: wordName(word) })}
      maxLength={MOST.letters}
      data-capitals={capitals(word)}
      style={{ ...place, '--fill': box.fill, '--ink': box.color, fontFamily: fontFamily(box.font) }}
      onKeyDown={press}
      onInput={({ currentTarget: { value } }) => {
        lettering.typed.value = value;
        if (isEffect && value.trim() !== '') lettering.edit(index, { text: value.trim() }, gesture);
      }}
      onBlur={(event) => end(event.currentTarget.value, false)}
      onClick={(event) => event.stopPropagation()}
      onPointerDown={(event) => event.stopPropagation()}
    >
      {first.current}
    </textarea>
  );
}

/** Moves the field below an effect, or above it near the end of the page. */
function moveBeside(area: HTMLTextAreaElement, page: HTMLElement, { x, y, width, height }: WordBox) {
  const { style, offsetHeight } = area;
  const [top, bottom] = [y * page.clientWidth - GAP, (y + height) * page.clientWidth + GAP];
  style.margin = '0';
  const middle = bottom + offsetHeight <= page.clientHeight ? bottom + offsetHeight / 2 : top - offsetHeight / 2;
  style.left = `${(x + width / 2) * page.clientWidth}px`;
  style.top = `${middle}px`;
  keepInside(area, page);
}

/** Moves the field into the page. */
function keepInside(
  { style, offsetTop, offsetLeft, offsetWidth, offsetHeight }: HTMLTextAreaElement,
  page: HTMLElement,
) {
  const inside = (at: number, length: number, room: number) =>
    Math.max(OUTLINE + length / 2 - at, Math.min(0, room - OUTLINE - at - length / 2));
  style.marginTop = `${inside(offsetTop, offsetHeight, page.clientHeight)}px`;
  style.marginLeft = `${inside(offsetLeft, offsetWidth, page.clientWidth)}px`;
}

/**
 * Sets the size to the size of the balloon and its text. The page limits the size, because the window may end there.
 * @param size of the balloon in page widths
 */
function grow(area: HTMLTextAreaElement, page: HTMLElement, size: readonly [number, number], kind: Word['kind']) {
  const { style } = area;
  const [wide, high] = size.map((length) => length * page.clientWidth);
  const across = Math.max(NARROWEST, wide);
  Object.assign(style, { width: `${across}px`, height: '0', paddingBlock: '0', margin: '0' });
  style.paddingInline = `${across * PADS[kind]}px`;
  const text = area.scrollHeight;
  const pad = kind === 'balloon' ? Math.max(LEAST_PAD, text * ROUND_PAD) : LEAST_PAD;
  const tall = Math.min(page.clientHeight - 2 * OUTLINE, Math.max(high, text + pad));
  const border = area.offsetHeight;
  style.height = `${tall}px`;
  style.paddingBlock = `${Math.max(0, (tall - text - border) / 2)}px`;
  keepInside(area, page);
}
