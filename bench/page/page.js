// @ts-check
/**
 * Functions that the runner calls in the page. They run one contestant after the other, in a separate thread or in this
 * one.
 */

import { contest } from './contest.js';
import { figures } from './figures.js';
import { masks } from './masks.js';
import { copySpeed } from './memory.js';
import { factsOf, plans } from './plans.js';

/** @typedef {import('./contest.js').Row} Row */
/** @typedef {import('./contest.js').Picture} Picture */

const SIZE = { width: 1920, height: 1080 };

/** @type {Promise<Picture> | undefined} */
let picture;

/**
 * A photo at the size of the benchmark.
 * @param {string} address
 * @returns {Promise<Picture>}
 */
async function load(address) {
  const bitmap = await createImageBitmap(await (await fetch(address)).blob());
  const canvas = new OffscreenCanvas(SIZE.width, SIZE.height);
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const scale = Math.max(SIZE.width / bitmap.width, SIZE.height / bitmap.height);
  context.drawImage(bitmap, 0, 0, bitmap.width * scale, bitmap.height * scale);
  return { ...SIZE, data: context.getImageData(0, 0, SIZE.width, SIZE.height).data };
}

/**
 * Times one contestant over the rows it can do. In a worker, as a page would use it; the canvas needs the
 * document for its SVG filter and runs here.
 * @param {string} name
 * @param {Row[]} rows
 * @param {string} photo address
 * @returns {Promise<Record<string, number>>} milliseconds by row id
 */
async function times(name, rows, photo) {
  const image = await (picture ??= load(photo));
  if (name === 'canvas') return contest(name, rows, image);
  const worker = new Worker('./worker.js', { type: 'module' });
  try {
    return await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => (data.error ? reject(new Error(data.error)) : resolve(data.times));
      worker.onerror = (event) => reject(new Error(event.message || 'its script does not load'));
      worker.postMessage({ name, rows, image });
    });
  } finally {
    worker.terminate();
  }
}

/** Rows are timed without the detectors' module, which may not be built. */
const detect = async () => (await import('./detect.js')).detect();
const aesthetics = async () => (await import('./aesthetics.js')).aesthetics();

/**
 * Milliseconds that facts of a photo take.
 * @param {string} photo address
 */
const facts = async (photo) => factsOf(await load(photo));

Object.assign(globalThis, { bench: { times, copySpeed, detect, aesthetics, figures, masks, facts, plans } });
