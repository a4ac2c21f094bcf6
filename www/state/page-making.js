// @ts-check
/** Pages as the bytes of one file, of each kind that there is. */

import { strings } from '../strings.js';
import { FORMATS, isArchive, pageName } from './formats.js';
import { archiveOf } from './keeping/archive.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('./formats.js').Format} Format */
/** @typedef {{ signal: AbortSignal, onProgress: (done: number, total: number) => void }} Work */
/** What every PNG of a whole page passes through before it leaves. @typedef {(png: Blob, page: PageDocument) => Promise<Blob>} Carry */
/** @typedef {{ pages: readonly PageDocument[], format: Format, inside?: import('./formats.js').Inside, quality?: number }} Wish `quality` from 1 to 100 */

export const USUAL_QUALITY = 88;

/**
 * @param {{
 *   store: import('./store.js').Store,
 *   engine: Pick<import('../engine/engine.js').Engine, 'exportPng' | 'exportJpeg' | 'exportWebp' | 'exportPdf'>,
 * }} app
 */
export function createMaking({ store, engine }) {
  return make;

  /**
   * @param {Wish} wish
   * @param {Work} how
   * @param {Carry} carry
   * @returns {Promise<Blob>}
   */
  async function make({ pages: documents, format, inside = 'png', quality = USUAL_QUALITY }, how, carry) {
    if (format === 'pdf') return engine.exportPdf(documents, { ...how, quality, title: store.project.peek().name || strings.name });
    if (!isArchive(format)) return picture(documents[0], /** @type {'png' | 'jpeg' | 'webp'} */ (format), quality, how, carry);
    const entries = [];
    for (const [i, document] of documents.entries()) {
      // Each page has the same share of the whole.
      const onProgress = (/** @type {number} */ done, /** @type {number} */ total) => how.onProgress(i + done / total, documents.length);
      const blob = await picture(document, inside, quality, { ...how, onProgress }, carry);
      entries.push({ name: pageName(i, documents.length, inside), blob });
    }
    return new Blob([await archiveOf(entries)], { type: FORMATS[format].type });
  }

  /**
   * @param {PageDocument} document
   * @param {'png' | 'jpeg' | 'webp'} format
   * @param {number} quality
   * @param {Work} how
   * @param {Carry} carry
   */
  async function picture(document, format, quality, how, carry) {
    if (format === 'jpeg') return engine.exportJpeg(document, { ...how, quality });
    if (format === 'webp') return engine.exportWebp(document, { ...how, quality });
    return carry(await engine.exportPng(document, how), document);
  }
}
