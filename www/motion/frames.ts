/** Content of a frame, from the table of the core, and its drawing. */

import { ANIMATIC } from '../engine/bounds.ts';
import type { Bounds } from '../engine/types.ts';

/** The part of a picture that is seen, in fractions of it. */
type View = Bounds;
export type Shown = { clip: number; view: View };
/**
 * One clip, and in a dissolve a second one above it with its opacity. For a page below: the number of visible text
 * items, the current panel (-1 for the whole page) and the darkness of the others. `beat` is the frame number of
 * animated panels.
 */
export type Frame = {
  under: Shown;
  over: (Shown & { share: number }) | null;
  words: number;
  panel: number;
  veil: number;
  beat: number;
};
/** A text item of a page, with the panel that it belongs to, and its position in fractions of the page. */
export type DrawnWord = { bitmap: ImageBitmap; panel: number; place: Bounds };
/** The pictures of a panel that moves; the place in fractions of the picture. */
export type DrawnLoop = { bitmaps: ImageBitmap[]; place: Bounds };
/**
 * The image of a clip, its caption, and its animated panels. Pages also have their text items in order of appearance,
 * and the outlines of their panels, in fractions of the page.
 */
export type Drawn = {
  picture: ImageBitmap;
  caption: ImageBitmap | null;
  loops?: DrawnLoop[];
  page?: { words: DrawnWord[]; panels: readonly (readonly [number, number][])[] };
};

type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/**
 * Pictures that are reduced by more than this factor need the slow resampling. Frames of a file are drawn near their size. There,
 * bilinear sampling looks equal, and takes less than half of the time without a GPU.
 */
const NEAR = 1.25;
/** Colour around a page, and of the dimming. */
const GROUND = '#15151a';
const VEIL = 0.8;

/** @param table as `Animatic::table` of the core */
export function frameAt(table: Float32Array, frame: number): Frame {
  const at = frame * ANIMATIC.columns;
  const shown = (from: number): Shown => ({
    clip: table[from],
    view: { x: table[from + 1], y: table[from + 2], width: table[from + 3], height: table[from + 4] },
  });
  const over = shown(at + 5);
  const [share, words, panel, veil, beat] = table.subarray(at + 10, at + ANIMATIC.columns);
  return { under: shown(at), over: over.clip < 0 ? null : { ...over, share }, words, panel, veil, beat };
}

/** @returns number of frames in a table */
export function framesIn(table: Float32Array): number {
  return table.length / ANIMATIC.columns;
}

/** @returns whether two frames show the same */
export function same(table: Float32Array, a: number, b: number): boolean {
  const row = (frame: number) => table.subarray(frame * ANIMATIC.columns, (frame + 1) * ANIMATIC.columns);
  const other = row(b);
  return row(a).every((value, i) => value === other[i]);
}

/** @returns the clips that a frame shows */
export function clipsOf({ under, over }: Pick<Frame, 'under' | 'over'>): number[] {
  return over ? [under.clip, over.clip] : [under.clip];
}

/** Frees all images. */
export function closeDrawn({ picture, caption, loops = [], page }: Drawn) {
  picture.close();
  caption?.close();
  for (const { bitmaps } of loops) for (const bitmap of bitmaps) bitmap.close();
  for (const { bitmap } of page?.words ?? []) bitmap.close();
}

/** @returns all pictures, to be handed over */
export function bitmapsOf({ picture, caption, loops = [], page }: Drawn): ImageBitmap[] {
  const words = page?.words.map(({ bitmap }) => bitmap) ?? [];
  return [picture, ...(caption ? [caption] : []), ...loops.flatMap(({ bitmaps }) => bitmaps), ...words];
}

/** @param drawn available parts of a clip; its caption fits frames of `captionWidth` */
export function drawFrame(
  context: Context,
  { under, over, beat, ...told }: Frame,
  { drawn, captionWidth }: { drawn: (clip: number) => Drawn | undefined; captionWidth: number },
) {
  layer(context, { shown: under, drawn: drawn(under.clip), captionWidth, beat, told });
  if (!over) return;
  context.globalAlpha = over.share;
  const unread = { words: 0, panel: -1, veil: 0 };
  layer(context, { shown: over, drawn: drawn(over.clip), captionWidth, beat, told: unread });
  context.globalAlpha = 1;
}

type Layer = {
  shown: Shown;
  drawn: Drawn | undefined;
  captionWidth: number;
  beat: number;
  told: Pick<Frame, 'words' | 'panel' | 'veil'>;
};

function layer(context: Context, { shown: { view }, drawn, captionWidth, beat, told }: Layer) {
  if (!drawn) return;
  const { width, height } = context.canvas;
  const { picture, caption, loops = [], page } = drawn;
  /** Bounds of a part of the image in the frame, in pixels. */
  const placed = ({ x, y, width: wide, height: high }: Bounds): [number, number, number, number] => [
    ((x - view.x) / view.width) * width,
    ((y - view.y) / view.height) * height,
    (wide / view.width) * width,
    (high / view.height) * height,
  ];
  context.imageSmoothingQuality = (view.width * picture.width) / width > NEAR ? 'high' : 'low';
  if (page) {
    const sheet = placed({ x: 0, y: 0, width: 1, height: 1 });
    beside(context, sheet);
    context.drawImage(picture, ...sheet);
  } else {
    context.drawImage(
      picture,
      view.x * picture.width,
      view.y * picture.height,
      view.width * picture.width,
      view.height * picture.height,
      0,
      0,
      width,
      height,
    );
  }
  for (const { bitmaps, place } of loops) context.drawImage(bitmaps[beat % bitmaps.length], ...placed(place));
  if (page) read(context, page, told, placed);
  if (!caption) return;
  const scale = width / captionWidth;
  const [wide, high] = [caption.width * scale, caption.height * scale];
  context.drawImage(
    caption,
    Math.round((width - wide) / 2),
    Math.round(Math.max(0, height * (1 - ANIMATIC.foot) - high)),
    wide,
    high,
  );
}

/** Paints the area around the page. */
function beside(context: Context, [x, y, wide, high]: [number, number, number, number]) {
  const { width, height } = context.canvas;
  context.fillStyle = GROUND;
  context.beginPath();
  context.rect(0, 0, width, height);
  context.rect(x, y, wide, high);
  context.fill('evenodd');
}

/** Draws the visible text, and dims everything except the current panel and its text. */
function read(
  context: Context,
  { words, panels }: NonNullable<Drawn['page']>,
  { words: count, panel, veil }: Layer['told'],
  placed: (place: Bounds) => [number, number, number, number],
) {
  const alpha = context.globalAlpha;
  const say = (mine: boolean) => {
    for (const [i, word] of words.entries()) {
      if (i >= count || (word.panel === panel) !== mine) continue;
      context.globalAlpha = alpha * Math.min(1, count - i);
      context.drawImage(word.bitmap, ...placed(word.place));
    }
    context.globalAlpha = alpha;
  };
  say(false);
  if (veil > 0) {
    context.globalAlpha = alpha * veil * VEIL;
    context.fillStyle = GROUND;
    context.beginPath();
    context.rect(0, 0, context.canvas.width, context.canvas.height);
    for (const [i, [x, y]] of (panels[panel] ?? []).entries()) {
      const [left, top] = placed({ x, y, width: 0, height: 0 });
      if (i === 0) context.moveTo(left, top);
      else context.lineTo(left, top);
    }
    context.closePath();
    context.fill('evenodd');
    context.globalAlpha = alpha;
  }
  say(true);
}
