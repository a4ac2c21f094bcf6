// @ts-check
/**
 * How large files will be. Pages are encoded at two small sizes: what the larger needs more than the smaller says what
 * the page at print size will need. Flat pictures grow slower than their pixels, noisy ones as fast.
 */

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/measures.js').PictureFormat} PictureFormat */
/** @typedef {{ bytes: number, pixels: number }} Measure */

/** Parts of the width at which pages are encoded. */
const PARTS = [1 / 8, 1 / 4];
/** So many pages of a long storyboard stand for all. */
const MOST_PAGES = 3;
/** The growth of the bytes with the pixels, as an exponent, lies between those. */
const [LEAST, MOST] = [0.5, 1];

/**
 * @param {readonly [Measure, Measure]} measures the smaller first
 * @param {number} pixels
 * @returns {number} bytes
 */
export function extrapolated([small, large], pixels) {
  const growth = Math.log(large.bytes / small.bytes) / Math.log(large.pixels / small.pixels);
  const exponent = Number.isFinite(growth) ? Math.min(MOST, Math.max(LEAST, growth)) : MOST;
  return large.bytes * (pixels / large.pixels) ** exponent;
}

/**
 * @param {Pick<import('../engine/engine.js').Engine, 'measureFile'>} engine
 * @param {readonly PageDocument[]} documents
 * @param {{ format: PictureFormat, quality: number, signal?: AbortSignal }} wish
 * @returns {Promise<number>} bytes of all pages together
 */
export async function estimated(engine, documents, wish) {
  const some = spread(documents, MOST_PAGES);
  let sum = 0;
  for (const document of some) {
    const { width, height } = document.page;
    /** @type {Measure[]} */
    const measures = [];
    for (const part of PARTS) measures.push(await engine.measureFile(document, { ...wish, width: Math.max(64, Math.round(width * part)) }));
    sum += extrapolated([measures[0], measures[1]], width * height);
  }
  return (sum / some.length) * documents.length;
}

/**
 * @template T
 * @param {readonly T[]} list
 * @param {number} most
 * @returns {T[]} the first, the last and some between
 */
export function spread(list, most) {
  if (list.length <= most) return [...list];
  return Array.from({ length: most }, (_, i) => list[Math.round((i * (list.length - 1)) / (most - 1))]);
}
