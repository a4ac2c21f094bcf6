/**
 * Estimates file sizes. Pages are encoded at two small sizes, and their growth predicts the size at print resolution.
 * Files of flat pictures grow slower than their pixels, files of noisy ones as fast.
 */

import type { PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { PictureFormat } from '../engine/measures.ts';

type Measure = { bytes: number; pixels: number };

/**
 * Fractions of the width at which pages are encoded. Over 26 styles, the estimate is off by a factor of 1.3 at most. An
 * eighth and a quarter take a fourth of the time. But then line patterns look like noise, and the factor is 2.2.
 */
const PARTS = [1 / 4, 1 / 2];
/** Maximum number of sampled pages of a long storyboard. */
const MOST_PAGES = 3;
/** Limits of the exponent with which bytes grow with pixels. */
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
