/**
 * Glyphs from system fonts, for characters that the bundled fonts lack. The browser shapes and draws them once in large
 * size, and the core traces the outlines. Words of joining or complex scripts are traced as a whole, other text by
 * character. Nothing is traced if the browser alters pixels that are read from a canvas.
 */

import type { Lettering } from '../pkg-words/inkpanel.js';
import type { PageDocument } from './types.ts';

/** The used functions of the glyph table. */
type Learner = Pick<Lettering, 'learn' | 'missing'>;
type Drawn = { ink: Uint8Array; width: number; baseline: number; left: number; advance: number };

/** Height of an em in the traced pictures, in pixels. Printed text is smaller. */
const EM = 144;
const AIR = 4;
/** Fonts of systems that draw signs in black, and whatever the system has. */
const FAMILY = `"Noto Emoji", "Segoe UI Symbol", "Noto Sans", system-ui, sans-serif`;
/** Maximum number of characters in a word. */
const LONGEST = 60;
/** Scripts that are shaped by word. */
const JOINED =
  /[\p{Script=Arabic}\p{Script=Hebrew}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}\p{Script=Devanagari}\p{Script=Bengali}\p{Script=Gurmukhi}\p{Script=Gujarati}\p{Script=Oriya}\p{Script=Tamil}\p{Script=Telugu}\p{Script=Kannada}\p{Script=Malayalam}\p{Script=Sinhala}\p{Script=Thai}\p{Script=Lao}\p{Script=Tibetan}\p{Script=Myanmar}\p{Script=Khmer}\p{Script=Mongolian}]/u;
const LEFTWARD = /[\p{Script=Arabic}\p{Script=Hebrew}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}]/u;
const EMOJI = /\p{Extended_Pictographic}/u;
/** Spaces, and characters that direct the order of others: they are not drawn, and end a run. */
const APART = /[\s\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]+/;
/** Characters with a shape: all except marks, joiners, controls and spaces. */
const SEEN = /[^\p{M}\p{Cf}\p{Cc}\p{Z}]/u;
/**
 * Characters without a glyph in any font. Their image is the sign for missing glyphs. Firefox draws the code of the
 * character into it, with four or six digits.
 */
const NOBODY = ['\u{10fffd}', '\uf8fd'];
/** Bundled font with the widest coverage, used to decide whether a glyph is missing. */
const FONT = 'comic-neue';

/**
 * Adds traced glyphs.
 * @returns a function that receives the text items of each page before they are measured or drawn
 */
export function createShaping(letters: Learner) {
  /** Texts that were already checked. */
  const seen: Set<string> = new Set();
  const tried: Set<string> = new Set();
  let pen: ReturnType<typeof createPen> | null | undefined;

  return (page: Pick<PageDocument, 'words'>) => {
    for (const { text } of page.words ?? []) {
      if (seen.has(text)) continue;
      seen.add(text);
      // Balloons may be set in capitals.
      if (letters.missing(text, FONT) !== '')
        for (const said of [text, text.toUpperCase()]) runsOf(said).forEach(learn);
    }
  };

  function runsOf(text: string): string[] {
    const segmenter = new Intl.Segmenter(undefined, { granularity: 'grapheme' });
    return text.split(APART).flatMap((word) => {
      if (letters.missing(word, FONT) === '') return [];
      if (JOINED.test(word)) return word.length <= LONGEST ? [word] : pieces(word, LONGEST);
      return [...segmenter.segment(word)].flatMap(({ segment }) =>
        letters.missing(segment, FONT) === '' ? [] : [segment],
      );
    });
  }

  function learn(run: string) {
    if (tried.has(run)) return;
    tried.add(run);
    pen ??= pen === undefined ? createPen() : null;
    const drawn = pen?.(run);
    if (!drawn) return;
    const { ink, width, baseline, left, advance } = drawn;
    letters.learn(run, LEFTWARD.test(run), width, ink, EM, baseline, left, advance);
  }
}

function pieces(word: string, length: number): string[] {
  const letters = [...word];
  return Array.from({ length: Math.ceil(letters.length / length) }, (_, i) =>
    letters.slice(i * length, (i + 1) * length).join(''),
  );
}

/** @returns draws a run, or returns null without a system font for it; null if pixels cannot be read */
function createPen(): ((run: string) => Drawn | null) | null {
  if (typeof OffscreenCanvas === 'undefined') return null;
  const canvas = new OffscreenCanvas(8, 8);
  const context = canvas.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D | null;
  if (!context || !isHonest(context)) return null;
  const nothing = NOBODY.flatMap((letter) => drawn(context, letter) ?? []);

  return (run) => {
    const emoji = EMOJI.test(run);
    if ([...run].some((letter) => isUnknown(letter))) return null;
    const picture = drawn(context, emoji && !run.includes('\ufe0f') ? `${run}\ufe0e` : run);
    return picture;
  };

  /** Whether the system draws its sign for missing glyphs. */
  function isUnknown(letter: string) {
    if (!SEEN.test(letter)) return false;
    const picture = drawn(context as OffscreenCanvasRenderingContext2D, letter);
    return picture !== null && nothing.some((other) => isSame(picture, other) || isSameBox(picture, other));
  }
}

/** Detects browsers that change canvas pixels to prevent fingerprinting. */
function isHonest(context: OffscreenCanvasRenderingContext2D): boolean {
  context.fillStyle = '#204060';
  context.fillRect(0, 0, 8, 8);
  const { data } = context.getImageData(0, 0, 8, 8);
  return data.every((value, i) => Math.abs(value - [0x20, 0x40, 0x60, 0xff][i % 4]) < 3);
}

function drawn(context: OffscreenCanvasRenderingContext2D, run: string): Drawn | null {
  const { canvas } = context;
  const set = () => {
    context.font = `700 ${EM}px ${FAMILY}`;
    context.textBaseline = 'alphabetic';
    context.textAlign = 'left';
    context.direction = LEFTWARD.test(run) ? 'rtl' : 'ltr';
    context.fillStyle = '#000';
  };
  set();
  const size = context.measureText(run);
  const left = Math.ceil(Math.max(0, size.actualBoundingBoxLeft)) + AIR;
  const baseline = Math.ceil(Math.max(0, size.actualBoundingBoxAscent)) + AIR;
  const width = left + Math.ceil(Math.max(size.width, size.actualBoundingBoxRight)) + AIR;
  const height = baseline + Math.ceil(Math.max(0, size.actualBoundingBoxDescent)) + AIR;
  if (width * height > 4_000_000) return null;
  // This empties it, too.
  canvas.width = width;
  canvas.height = height;
  set();
  context.fillText(run, left, baseline);
  const { data } = context.getImageData(0, 0, width, height);
  const ink = new Uint8Array(width * height);
  let coloured = 0;
  for (let i = 0; i < ink.length; i += 1) {
    ink[i] = data[i * 4 + 3];
    if (ink[i] > 128 && data[i * 4] + data[i * 4 + 1] + data[i * 4 + 2] > 60) coloured += 1;
  }
  if (coloured > 40) line(ink, data, width);
  if (!ink.some((value) => value > 128)) return null;
  return { ink, width, baseline, left, advance: size.width };
}

/** Converts a coloured image to a drawing: its edges and its dark areas. */
function line(ink: Uint8Array, data: Uint8ClampedArray, width: number) {
  const reach = Math.round(EM / 26);
  const alpha = Uint8Array.from(ink);
  const height = ink.length / width;
  const inside = (x: number, y: number) => x >= 0 && y >= 0 && x < width && y < height && alpha[y * width + x] > 128;
  for (let i = 0; i < ink.length; i += 1) {
    const [x, y] = [i % width, Math.floor(i / width)];
    const [red, green, blue] = [data[i * 4], data[i * 4 + 1], data[i * 4 + 2]];
    const dark = 0.299 * red + 0.587 * green + 0.114 * blue < 110;
    const edge = [
      [reach, 0],
      [-reach, 0],
      [0, reach],
      [0, -reach],
    ].some(([dx, dy]) => !inside(x + dx, y + dy));
    ink[i] = alpha[i] > 128 && (dark || edge) ? alpha[i] : 0;
  }
}

/** Returns whether both are placeholder boxes of equal shape. */
function isSameBox(one: Drawn, box: Drawn): boolean {
  if (one.width !== box.width || one.ink.length !== box.ink.length) return false;
  const height = box.ink.length / box.width;
  const columns = Array.from({ length: box.width }, (_, x) => x);
  const rows = Array.from({ length: height }, (_, y) => y);
  const inked = (x: number, y: number) => box.ink[y * box.width + x] > 128;
  const across = columns.filter((x) => rows.some((y) => inked(x, y)));
  const down = rows.filter((y) => columns.some((x) => inked(x, y)));
  const [left, right, top, bottom] = [across[0], across.at(-1) ?? 0, down[0], down.at(-1) ?? 0];
  /** The outermost line of ink. */
  const frame = [
    ...across.flatMap((x) => [top * box.width + x, bottom * box.width + x]),
    ...down.flatMap((y) => [y * box.width + left, y * box.width + right]),
  ];
  return frame.every((i) => box.ink[i] > 128 && one.ink[i] > 128);
}

function isSame(one: Drawn, other: Drawn): boolean {
  return (
    one.width === other.width && one.ink.length === other.ink.length && one.ink.every((v, i) => v === other.ink[i])
  );
}
