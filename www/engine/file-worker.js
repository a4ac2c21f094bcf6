// @ts-check
/**
 * The worker that makes files: the module of words, loaded with the first job, and the browser's own encoder of WebP.
 */

import initWords, { Book, Cut, Lettering, Print } from '../pkg-words/inkpanel.js';
import { blobOf } from './blobs.js';
import { describe, failure } from './protocol.js';
import { withDpi } from './webp.js';

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);

/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {import('./files.js').Picture} Picture */
/** @typedef {{ ok: any, transfer: Transferable[] }} Answer */

/** @type {Promise<WebAssembly.Memory> | undefined} */
let started;

/** @type {Record<string, (args: any) => Promise<Answer>>} */
const OPERATIONS = { jpeg, webp, pictures, pdf };

/** @param {MessageEvent<{ id: number, op: string, args: any }>} event */
globalThis.onmessage = async ({ data: { id, op, args } }) => {
  try {
    // WebP is the browser's own work.
    if (op !== 'webp') started ??= start();
    const memory = await started;
    const { ok, transfer } = await OPERATIONS[op](args);
    postMessage({ id, ok, memory: memory?.buffer.byteLength ?? 0 }, { transfer });
  } catch (error) {
    postMessage({ id, error: describe(error), memory: 0 });
  }
};

async function start() {
  const response = await fetch(MODULE).catch(() => null);
  if (!response?.ok) throw failure('words-missing', 'The part of the program that makes this kind of file could not be loaded. Try again, or save a PNG.');
  const { memory } = await initWords({ module_or_path: await response.arrayBuffer() });
  return memory;
}

/** @param {{ document: string, size: { width: number, height: number }, patches: PixelPatch[], quality: number }} args @returns {Promise<Answer>} */
async function jpeg({ document, size, patches, quality }) {
  const print = new Print(document, size.width, size.height);
  try {
    for (const { x, y, width, height, data } of patches) print.lay(x, y, width, height, bytesOf(data));
    const bytes = /** @type {Uint8Array<ArrayBuffer>} */ (print.jpeg(quality));
    return { ok: await blobOf(bytes, { type: 'image/jpeg' }), transfer: [] };
  } finally {
    print.free();
  }
}

/** @param {{ picture: Blob, quality: number, dpi: number }} args @returns {Promise<Answer>} */
async function webp({ picture, quality, dpi }) {
  const bitmap = await createImageBitmap(picture);
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d')).drawImage(bitmap, 0, 0);
  bitmap.close();
  const made = await canvas.convertToBlob({ type: 'image/webp', quality: quality / 100 });
  if (made.type !== 'image/webp') throw failure('no-webp', 'This browser makes no WebP files. Choose PNG or JPEG.');
  const { width, height } = canvas;
  return { ok: withDpi(new Uint8Array(await made.arrayBuffer()), { width, height, dpi }), transfer: [] };
}

/** @param {{ document: string, patches: (PixelPatch & { index: number })[], quality: number }} args @returns {Promise<Answer>} */
async function pictures({ document, patches, quality }) {
  /** @type {Picture[]} */
  const ok = patches.map(({ index, x, y, width, height, data }) => {
    const cut = new Cut(document, index, x, y, width, height, bytesOf(data), quality);
    const made = /** @type {Uint8Array<ArrayBuffer>} */ (cut.take());
    const place = { x: cut.x, y: cut.y, width: cut.width, height: cut.height };
    cut.free();
    return { index, ...place, jpeg: made };
  });
  return { ok, transfer: ok.map((picture) => picture.jpeg.buffer) };
}

/** @param {{ pages: { document: string, pictures: Picture[] }[], title: string }} args @returns {Promise<Answer>} */
async function pdf({ pages, title }) {
  const book = new Book();
  const letters = new Lettering();
  try {
    for (const page of pages) {
      book.add_page(page.document);
      for (const { index, x, y, width, height, jpeg: bytes } of page.pictures) book.add_picture(index, x, y, width, height, bytes);
    }
    const bytes = /** @type {Uint8Array<ArrayBuffer>} */ (book.finish(letters, title));
    return { ok: await blobOf(bytes, { type: 'application/pdf' }), transfer: [] };
  } finally {
    book.free();
    letters.free();
  }
}

/** @param {Uint8ClampedArray<ArrayBuffer>} data */
function bytesOf(data) {
  return new Uint8Array(data.buffer, data.byteOffset, data.length);
}
