// @ts-check
/** A storyboard for the tests of its state. */

import { createBook } from './book.js';
import { keepBook } from './book-upkeep.js';
import { fakeApp } from './testing.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */

const names = (/** @type {number} */ count) => Array.from({ length: count }, (_, i) => `${i}.jpg`);
export const photosOfPage = (/** @type {PageDocument} */ page) => page.panels.map(({ photo }) => photo);

/** A storyboard of one page, with so many photos. @param {number} count */
export async function opened(count) {
  const app = fakeApp();
  const book = createBook(app);
  /** @type {(() => void)[]} */
  const waiting = [];
  keepBook({ store: app.store, pages: app.pages, later: (work) => waiting.push(work) });
  await app.reading.addFiles(app.files(...names(count)));
  const ids = () => app.store.photos.value.map(({ id }) => id);
  const shown = () => app.store.sheets.value.map(photosOfPage);
  const idle = () => { while (waiting.length > 0) waiting.shift()?.(); };
  return { ...app, book, ids, shown, idle };
}
