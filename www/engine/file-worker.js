// @ts-check
/**
 * The worker that makes files: the module of words, loaded with the first job, and the browser's own encoder of WebP.
 */

import initWords, { Book, Cut, Lettering, Print } from '../pkg-words/inkpanel.js';
import { blobOf } from './blobs.js';
import { fileMs } from './measured.js';
import { failure } from './protocol.js';
import { LOADING, STORING, serveJobs } from './serving.js';
import { withDpi } from './webp.js';

const MODULE = new URL('../pkg-words/inkpanel_bg.wasm', import.meta.url);

/** Milliseconds for a page of a PDF file, whose pictures are made by then. */
const PAGE = 500;

/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {import('./files.js').Picture} Picture */
/** @typedef {{ ok: any, transfer: Transferable[] }} Answer */
/** @typedef {import('./serving.js').Tell} Tell */

/** @type {Promise<WebAssembly.Memory> | undefined} */
let started;

/** @type {Record<string, (args: any, tell: Tell) => Promise<Answer>>} */
const OPERATIONS = { jpeg, webp, pictures, pdf };

serveJobs(async (op, args, tell) => {
  tell.waits(LOADING);
  // WebP is the browser's own work.
  if (op !== 'webp') started ??= start();
  const memory = await started;
  const answer = await OPERATIONS[op](args, tell);
  return { ...answer, memory: memory?.buffer.byteLength ?? 0 };
});

async function start() {
  const response = await fetch(MODULE).catch(() => null);
  if (!response?.ok) throw failure('words-missing', 'The part of the program that makes this kind of file could not be loaded. Try again, or save a PNG.');
  const { memory } = await initWords({ module_or_path: await response.arrayBuffer() });
  return memory;
}

/** @param {{ document: string, size: { width: number, height: number }, patches: PixelPatch[], quality: number }} args @param {Tell} tell @returns {Promise<Answer>} */
async function jpeg({ document, size, patches, quality }, tell) {
  tell.expects(fileMs(2 * size.width * size.height));
  const print = new Print(document, size.width, size.height);
  try {
    for (const { x, y, width, height, data } of patches) print.lay(x, y, width, height, bytesOf(data));
    const bytes = /** @type {Uint8Array<ArrayBuffer>} */ (print.jpeg(quality));
    tell.waits(STORING);
    return { ok: await blobOf(bytes, { type: 'image/jpeg' }), transfer: [] };
  } finally {
    print.free();
  }
}

/** @param {{ picture: Blob, quality: number, dpi: number }} args @param {Tell} tell @returns {Promise<Answer>} */
async function webp({ picture, quality, dpi }, tell) {
  const bitmap = await createImageBitmap(picture);
  tell.expects(fileMs(4 * bitmap.width * bitmap.height));
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d')).drawImage(bitmap, 0, 0);
  bitmap.close();
  const made = await canvas.convertToBlob({ type: 'image/webp', quality: quality / 100 });
  if (made.type !== 'image/webp') throw failure('no-webp', 'This browser makes no WebP files. Choose PNG or JPEG.');
  const { width, height } = canvas;
  return { ok: withDpi(new Uint8Array(await made.arrayBuffer()), { width, height, dpi }), transfer: [] };
}

/** @param {{ document: string, patches: (PixelPatch & { index: number })[], quality: number }} args @param {Tell} tell @returns {Promise<Answer>} */
async function pictures({ document, patches, quality }, tell) {
  /** @type {Picture[]} */
  const ok = patches.map(({ index, x, y, width, height, data }) => {
    tell.expects(fileMs(2 * width * height));
    const cut = new Cut(document, index, x, y, width, height, bytesOf(data), quality);
    const made = /** @type {Uint8Array<ArrayBuffer>} */ (cut.take());
    const place = { x: cut.x, y: cut.y, width: cut.width, height: cut.height };
    cut.free();
    return { index, ...place, jpeg: made };
  });
  return { ok, transfer: ok.map((picture) => picture.jpeg.buffer) };
}

/** @param {{ pages: { document: string, pictures: Picture[] }[], title: string }} args @param {Tell} tell @returns {Promise<Answer>} */
async function pdf({ pages, title }, tell) {
  const book = new Book();
  const letters = new Lettering();
  try {
    for (const page of pages) {
      tell.expects(PAGE);
      book.add_page(page.document);
      for (const { index, x, y, width, height, jpeg: bytes } of page.pictures) book.add_picture(index, x, y, width, height, bytes);
    }
    tell.expects(PAGE * pages.length);
    const bytes = /** @type {Uint8Array<ArrayBuffer>} */ (book.finish(letters, title));
    tell.waits(STORING);
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
