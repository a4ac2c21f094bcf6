// @ts-check
/**
 * Files that the core does not make: JPEG, WebP and PDF. A worker of its own with the module of words, loaded when the
 * first is asked for, so that words on the screen do not wait for a file.
 */

import { createPool } from './pool.js';
import { Priority } from './queue.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {import('./protocol.js').Box} Box */
/** @typedef {{ signal?: AbortSignal }} Call */
/** @typedef {Box & { index: number, jpeg: Uint8Array<ArrayBuffer> }} Picture a panel in a PDF file */

export function createFiles() {
  /** @type {ReturnType<typeof createPool> | undefined} */
  let pool;

  return { jpeg, webp, pictures, pdf, dispose: () => pool?.dispose() };

  /**
   * @param {string} op
   * @param {object} args
   * @param {Transferable[]} transfer
   * @param {Call} [call]
   */
  function run(op, args, transfer, call) {
    pool ??= createPool({ size: 1, spawn });
    return pool.run({ op, args, transfer, priority: Priority.PAGE, ...call });
  }

  /**
   * A page, of the patches that lie on it.
   * @param {PageDocument} document
   * @param {{ width: number, height: number }} size in pixels
   * @param {PixelPatch[]} patches are handed over
   * @param {number} quality from 1 to 100
   * @param {Call} [call]
   * @returns {Promise<Blob>}
   */
  async function jpeg(document, { width, height }, patches, quality, call) {
    return run('jpeg', { document: JSON.stringify(document), size: { width, height }, patches, quality }, buffersOf(patches), call);
  }

  /**
   * @param {Blob} picture that the browser can read
   * @param {{ quality: number, dpi: number }} wish `quality` from 1 to 100
   * @param {Call} [call]
   * @returns {Promise<Blob>}
   */
  async function webp(picture, { quality, dpi }, call) {
    return run('webp', { picture, quality, dpi }, [], call);
  }

  /**
   * Panels as a PDF file has them.
   * @param {PageDocument} document
   * @param {(PixelPatch & { index: number })[]} patches panels drawn without borders at full width; they are handed over
   * @param {number} quality from 1 to 100
   * @param {Call} [call]
   * @returns {Promise<Picture[]>}
   */
  async function pictures(document, patches, quality, call) {
    return run('pictures', { document: JSON.stringify(document), patches, quality }, buffersOf(patches), call);
  }

  /**
   * @param {{ document: PageDocument, pictures: Picture[] }[]} pages the pictures are handed over
   * @param {string} title
   * @param {Call} [call]
   * @returns {Promise<Blob>}
   */
  async function pdf(pages, title, call) {
    const args = { title, pages: pages.map((page) => ({ ...page, document: JSON.stringify(page.document) })) };
    return run('pdf', args, pages.flatMap((page) => page.pictures.map((picture) => picture.jpeg.buffer)), call);
  }
}

/** @param {PixelPatch[]} patches */
function buffersOf(patches) {
  return patches.map(({ data }) => data.buffer);
}

function spawn() {
  return new Worker(new URL('./file-worker.js', import.meta.url), { type: 'module', name: 'inkpanel-files' });
}
