/** What a frame of an animatic shows, out of the table that the core made, and how it is drawn. */

import { ANIMATIC } from '../engine/bounds.ts';

/** The part of a picture that is seen, in fractions of it. */
type View = { x: number; y: number; width: number; height: number };
export type Shown = { clip: number; view: View };
/** One clip, and in a dissolve another over it, of which so much is seen. */
export type Frame = { under: Shown; over: (Shown & { share: number }) | null };
/** The picture of a clip, and what stands below. */
export type Drawn = { picture: ImageBitmap; caption: ImageBitmap | null };

type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/** @param table as `Animatic::table` of the core */
export function frameAt(table: Float32Array, frame: number): Frame {
  const at = frame * ANIMATIC.columns;
  const shown = (from: number): Shown => ({
    clip: table[from],
    view: { x: table[from + 1], y: table[from + 2], width: table[from + 3], height: table[from + 4] },
  });
  const over = shown(at + 5);
  return { under: shown(at), over: over.clip < 0 ? null : { ...over, share: table[at + 10] } };
}

/** @returns how many frames a table tells */
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
export function clipsOf({ under, over }: Frame): number[] {
  return over ? [under.clip, over.clip] : [under.clip];
}

/**
 * @param drawn a clip's picture and its caption; the caption was made for frames `captionWidth` wide
 */
export function drawFrame(
  context: Context,
  { under, over }: Frame,
  { drawn, captionWidth }: { drawn: (clip: number) => Drawn | undefined; captionWidth: number },
) {
  layer(context, under, drawn(under.clip), captionWidth);
  if (!over) return;
  context.globalAlpha = over.share;
  layer(context, over, drawn(over.clip), captionWidth);
  context.globalAlpha = 1;
}

function layer(context: Context, { view }: Shown, drawn: Drawn | undefined, captionWidth: number) {
  if (!drawn) return;
  const { width, height } = context.canvas;
  const { picture, caption } = drawn;
  context.imageSmoothingQuality = 'high';
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
