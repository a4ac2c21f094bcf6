/** Animated panels as images over the image of the page. Each includes the panels and text above it. */

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
/** Pixel limit for lossless encoding, which needs more space. */
const LOSSLESS_PIXELS = 12e6;
const QUALITY = 0.75;
const FRAME_MS = Math.round(1000 / LIVING.rate);

/** A picture that moves; the place in fractions of the page. */
export type MovingPicture = { place: Bounds; file: Blob };

/** @returns encodes the canvas as a WebP file; the images of a loop arrive in order */
type Encoder = (
  canvas: OffscreenCanvas,
  context: OffscreenCanvasRenderingContext2D,
) => Promise<Uint8Array<ArrayBuffer>>;

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
      const files = await filesOf(loop, over, lossy ? lossyFile : losslessEncoder(signal));
      const file = animatedWebp(files, loop.bitmaps[0], FRAME_MS, !lossy);
      pictures.push({ place: loop.place, file });
    }
    return pictures;
  };

  /** A custom encoder: every picture except the first contains only its changes. */
  function losslessEncoder(signal?: AbortSignal): Encoder {
    let before: Uint8ClampedArray<ArrayBuffer> | undefined;
    return (canvas, context) => {
      const { width, height } = canvas;
      const { data } = context.getImageData(0, 0, width, height);
      const fresh = before ? changesOf(data, before) : data.slice();
      before = data;
      return engine.losslessPicture({ width, height, data: fresh }, { signal });
    };
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

const lossyFile: Encoder = async (canvas) => {
  const still = await canvas.convertToBlob({ type: 'image/webp', quality: QUALITY });
  return new Uint8Array(await still.arrayBuffer());
};

/**
 * Draws the pictures of a loop one after the other, and encodes each.
 * @param over the panels above it, in paint order; of animated ones only the first image
 */
async function filesOf({ place, bitmaps }: DrawnLoop, over: readonly DrawnLoop[], encode: Encoder) {
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
    files.push(await encode(canvas, context));
  }
  return files;
}
