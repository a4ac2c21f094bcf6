// @ts-check
/**
 * The worker that draws words: their wasm module, loaded with the first job.
 */

import initWords, { Lettering } from '../pkg-words/inkpanel.js';
import { wordMs } from './measured.js';
import { failure } from './protocol.js';
import { LOADING, serveJobs } from './serving.js';

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);

/** @typedef {{ document: string, width: number, index: number, bitmap: ImageBitmap }} Args */
/** @typedef {{ ok: any, transfer: Transferable[] }} Answer */
/** @typedef {import('./serving.js').Tell} Tell */

/** @type {Promise<Lettering> | undefined} */
let started;

/** @type {Record<string, (letters: Lettering, args: Args, tell: Tell) => Promise<Answer>>} */
const OPERATIONS = { word, words, over };

serveJobs(async (op, args, tell) => {
  tell.waits(LOADING);
  started ??= start();
  return OPERATIONS[op](await started, args, tell);
});

async function start() {
  const response = await fetch(MODULE).catch(() => null);
  if (!response?.ok) throw failure('words-missing', 'The letters could not be loaded.');
  await initWords({ module_or_path: await response.arrayBuffer() });
  return new Lettering();
}

/** @param {Lettering} letters @param {Args} args @param {Tell} tell @returns {Promise<Answer>} */
async function word(letters, { document, index, width }, tell) {
  tell.expects(wordMs(width * width));
  const { data, ...place } = pixels(letters, document, index, width);
  const bitmap = await createImageBitmap(new ImageData(data, place.width, place.height));
  return { ok: { ...place, bitmap }, transfer: [bitmap] };
}

/** @param {Lettering} letters @param {Args} args @param {Tell} tell @returns {Promise<Answer>} */
async function words(letters, { document, width }, tell) {
  const ok = all(letters, document, width, tell);
  return { ok, transfer: ok.map(({ data }) => data.buffer) };
}

/** @param {Lettering} letters @param {Args} args @param {Tell} tell @returns {Promise<Answer>} */
async function over(letters, { document, width, bitmap }, tell) {
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.drawImage(bitmap, 0, 0);
  for (const { data, x, y, ...size } of all(letters, document, width, tell)) {
    context.drawImage(await createImageBitmap(new ImageData(data, size.width, size.height)), x, y);
  }
  const drawn = canvas.transferToImageBitmap();
  return { ok: drawn, transfer: [drawn] };
}

/** @param {Lettering} letters @param {string} document @param {number} width @param {Tell} tell */
function all(letters, document, width, tell) {
  const { length } = JSON.parse(document).words;
  return Array.from({ length }, (_, index) => {
    tell.expects(wordMs(width * width));
    return pixels(letters, document, index, width);
  });
}

/** @param {Lettering} letters @param {string} document @param {number} index @param {number} width */
function pixels(letters, document, index, width) {
  const picture = letters.render(document, index, width);
  const { x, y, width: wide, height } = picture;
  const data = /** @type {Uint8ClampedArray<ArrayBuffer>} */ (picture.take());
  picture.free();
  return { x, y, width: wide, height, data };
}
