/**
 * The panels of a page that move, as pictures that lie over that of the page: what lies over such a panel, other panels and words,
 * is in its picture.
 */

import { paintOrder } from '../engine/figures.ts';
import { LIVING } from '../engine/living.ts';
import { animatedWebp } from './animated-webp.ts';
import { drawnWord } from './drawn-word.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { DrawnLoop } from './frames.ts';
import type { createLoops } from './loops.ts';

/** Pixels of all pictures of all panels of a page. */
const PIXELS = 24e6;
const QUALITY = 0.75;

/** A picture that moves; the place in fractions of the page. */
export type MovingPicture = { place: Bounds; file: Blob };

export function createMovingPictures({
  engine,
  loops,
}: {
  engine: Pick<Engine, 'renderWord' | 'givesWebp'>;
  loops: ReturnType<typeof createLoops>;
}) {
  /** @returns none where the browser makes no WebP files: the panels stay still */
  return async function movingPictures(
    document: PageDocument,
    { signal }: { signal?: AbortSignal } = {},
  ): Promise<MovingPicture[]> {
    if (!(await engine.givesWebp())) return [];
    const all = await loops.of(document, PIXELS, { signal });
    const pictures: MovingPicture[] = [];
    for (const [i, loop] of all.entries()) {
      if (loop.bitmaps.length < 2) continue;
      const width = loop.bitmaps[0].width / loop.place.width;
      const over = [...all.slice(i + 1), ...(await wordsOf(document, Math.round(width), signal))];
      const file = await film(loop, over);
      pictures.push({ place: loop.place, file });
    }
    return pictures;
  };

  async function wordsOf(document: PageDocument, width: number, signal?: AbortSignal): Promise<DrawnLoop[]> {
    const drawn: DrawnLoop[] = [];
    for (const index of paintOrder(document)) {
      const { bitmap, place } = await drawnWord(engine, document, index, width, { signal });
      drawn.push({ place, bitmaps: [bitmap] });
    }
    return drawn;
  }
}

/** @param over what lies over it, in paint order: of a panel that moves too its first picture, which is all that is needed of it */
async function film({ place, bitmaps }: DrawnLoop, over: readonly DrawnLoop[]): Promise<Blob> {
  const [{ width, height }] = bitmaps;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  const files: Uint8Array<ArrayBuffer>[] = [];
  for (const bitmap of bitmaps) {
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
    const still = await canvas.convertToBlob({ type: 'image/webp', quality: QUALITY });
    files.push(new Uint8Array(await still.arrayBuffer()));
  }
  return animatedWebp(files, { width, height }, Math.round(1000 / LIVING.rate));
}
