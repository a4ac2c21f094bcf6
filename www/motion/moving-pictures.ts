/**
 * The panels of a page that move, as pictures that lie over that of the page: what lies over such a panel, other panels and words,
 * is in its picture.
 */

import { paintOrder } from '../engine/figures.ts';
import { LIVING } from '../engine/living.ts';
import { animatedWebp, changesOf } from './animated-webp.ts';
import { drawnWord } from './drawn-word.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { DrawnLoop } from './frames.ts';
import type { createLoops } from './loops.ts';

/** Pixels of all pictures of all panels of a page. */
const PIXELS = 24e6;
/** The same where they are encoded without loss, which takes more room. */
const LOSSLESS_PIXELS = 12e6;
const QUALITY = 0.75;
const FRAME_MS = Math.round(1000 / LIVING.rate);

/** A picture that moves; the place in fractions of the page. */
export type MovingPicture = { place: Bounds; file: Blob };

export function createMovingPictures({
  engine,
  loops,
}: {
  engine: Pick<Engine, 'renderWord' | 'givesWebp' | 'losslessPicture'>;
  loops: ReturnType<typeof createLoops>;
}) {
  return async function movingPictures(
    document: PageDocument,
    { signal }: { signal?: AbortSignal } = {},
  ): Promise<MovingPicture[]> {
    const lossy = await engine.givesWebp();
    const all = await loops.of(document, lossy ? PIXELS : LOSSLESS_PIXELS, { signal });
    const pictures: MovingPicture[] = [];
    for (const [i, loop] of all.entries()) {
      if (loop.bitmaps.length < 2) continue;
      const width = loop.bitmaps[0].width / loop.place.width;
      const over = [...all.slice(i + 1), ...(await wordsOf(document, Math.round(width), signal))];
      const file = lossy ? await lossyFilm(loop, over) : await losslessFilm(loop, over, signal);
      pictures.push({ place: loop.place, file });
    }
    return pictures;
  };

  /** By our own encoder, of each picture what changed. */
  async function losslessFilm(loop: DrawnLoop, over: readonly DrawnLoop[], signal?: AbortSignal): Promise<Blob> {
    const { canvas, context, draw } = easelOf(loop, over);
    const { width, height } = canvas;
    const files: Uint8Array<ArrayBuffer>[] = [];
    let before: Uint8ClampedArray<ArrayBuffer> | undefined;
    for (const bitmap of loop.bitmaps) {
      draw(bitmap);
      const { data } = context.getImageData(0, 0, width, height);
      const fresh = before ? changesOf(data, before) : data.slice();
      files.push(await engine.losslessPicture({ x: 0, y: 0, width, height, data: fresh }, { signal }));
      before = data;
    }
    return animatedWebp(files, canvas, FRAME_MS, true);
  }

  async function wordsOf(document: PageDocument, width: number, signal?: AbortSignal): Promise<DrawnLoop[]> {
    const drawn: DrawnLoop[] = [];
    for (const index of paintOrder(document)) {
      const { bitmap, place } = await drawnWord(engine, document, index, width, { signal });
      drawn.push({ place, bitmaps: [bitmap] });
    }
    return drawn;
  }
}

/** By the encoder of the browser. */
async function lossyFilm(loop: DrawnLoop, over: readonly DrawnLoop[]): Promise<Blob> {
  const { canvas, draw } = easelOf(loop, over);
  const files: Uint8Array<ArrayBuffer>[] = [];
  for (const bitmap of loop.bitmaps) {
    draw(bitmap);
    const still = await canvas.convertToBlob({ type: 'image/webp', quality: QUALITY });
    files.push(new Uint8Array(await still.arrayBuffer()));
  }
  return animatedWebp(files, canvas, FRAME_MS);
}

/**
 * Where the pictures of a loop are drawn.
 * @param over what lies over it, in paint order: of a panel that moves too its first picture, which is all that is needed of it
 */
function easelOf({ place, bitmaps }: DrawnLoop, over: readonly DrawnLoop[]) {
  const [{ width, height }] = bitmaps;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;

  function draw(bitmap: ImageBitmap) {
    context.clearRect(0, 0, width, height);
    context.drawImage(bitmap, 0, 0);
    for (const {
      place: other,
      bitmaps: [first],
    } of over)
      context.drawImage(
        first,
        ((other.x - place.x) / place.width) * width,
        ((other.y - place.y) / place.height) * height,
        (other.width / place.width) * width,
        (other.height / place.height) * height,
      );
  }

  return { canvas, context, draw };
}
