// @ts-check
/** How large a page is as a file, by encoding it small. */

import { Priority } from './queue.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {'png' | 'jpeg' | 'webp'} PictureFormat */

/**
 * @param {{
 *   run: (job: import('./pool.js').Job) => Promise<any>, renders: Pick<ReturnType<typeof import('./renders.js').createRenders>, 'composePixels'>,
 *   files: ReturnType<typeof import('./files.js').createFiles>,
 * }} engine
 */
export function createMeasures({ run, renders, files }) {
  return { measureFile };

  /**
   * @param {PageDocument} document
   * @param {{ width: number, format: PictureFormat, quality: number, signal?: AbortSignal }} wish `width` of the page in pixels
   * @returns {Promise<{ bytes: number, pixels: number }>} the size of the file, and of the picture in it
   */
  async function measureFile(document, { width, format, quality, signal }) {
    const page = await renders.composePixels(document, width, { signal });
    const pixels = page.width * page.height;
    if (format === 'jpeg') return { bytes: (await files.jpeg(document, page, [page], quality, { signal })).size, pixels };
    const args = { document: JSON.stringify(document), width, patches: [{ ...page, index: 0 }] };
    const png = await run({ op: 'encode', args, transfer: [page.data.buffer], priority: Priority.PAGE, signal });
    const file = format === 'png' ? png : await files.webp(png, { quality, dpi: document.page.dpi }, { signal });
    return { bytes: file.size, pixels };
  }
}
