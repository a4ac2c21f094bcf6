/**
 * How large files will be. Pages are encoded at two small sizes: what the larger needs more than the smaller says what
 * the page at print size will need. Flat pictures grow slower than their pixels, noisy ones as fast.
 */

import type { PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { PictureFormat } from '../engine/measures.ts';

type Measure = { bytes: number; pixels: number };

/**
 * Parts of the width at which pages are encoded: over 26 styles the size told is off by 1.3 at most. An eighth and a
 * quarter take a fourth of the time, but patterns of lines then look like noise: off by 2.2.
 */
const PARTS = [1 / 4, 1 / 2];
/** So many pages of a long storyboard stand for all. */
const MOST_PAGES = 3;
/** The growth of the bytes with the pixels, as an exponent, lies between those. */
const [LEAST, MOST] = [0.5, 1];

/**
 * @param measures the smaller first
 * @returns bytes
 */
export function extrapolated([small, large]: readonly [Measure, Measure], pixels: number): number {
  const growth = Math.log(large.bytes / small.bytes) / Math.log(large.pixels / small.pixels);
  const exponent = Number.isFinite(growth) ? Math.min(MOST, Math.max(LEAST, growth)) : MOST;
  return large.bytes * (pixels / large.pixels) ** exponent;
}

/** @returns bytes of all pages together */
export async function estimated(
  engine: Pick<Engine, 'measureFile'>,
  documents: readonly PageDocument[],
  wish: { format: PictureFormat; quality: number; signal?: AbortSignal },
): Promise<number> {
  const some = spread(documents, MOST_PAGES);
  let sum = 0;
  for (const document of some) {
    const { width, height } = document.page;
    const measures: Measure[] = [];
    for (const part of PARTS)
      measures.push(await engine.measureFile(document, { ...wish, width: Math.max(64, Math.round(width * part)) }));
    sum += extrapolated([measures[0], measures[1]], width * height);
  }
  return (sum / some.length) * documents.length;
}

/** @returns the first, the last and some between */
export function spread<T>(list: readonly T[], most: number): T[] {
  if (list.length <= most) return [...list];
  return Array.from({ length: most }, (_, i) => list[Math.round((i * (list.length - 1)) / (most - 1))]);
}
