/** A storyboard for the tests of its state. */

import { createBook } from './book.ts';
import { keepBook } from './book-upkeep.ts';
import { fakeApp, orderByName } from '../document/testing.ts';
import type { PageDocument } from '../engine/types.ts';

const names = (count: number) => Array.from({ length: count }, (_, i) => `${i}.jpg`);
export const photosOfPage = (page: PageDocument) => page.panels.map(({ photo }) => photo);

/**
 * A storyboard of one page, with a number of photos.
 * @param how `byName`: sorted by name
 */
export async function opened(count: number, { byName = false }: { byName?: boolean } = {}) {
  const app = fakeApp();
  if (byName) orderByName(app);
  const book = createBook(app);
  const waiting: (() => unknown)[] = [];
  const background = (work: () => unknown) => void waiting.push(work);
  keepBook({ store: app.store, pages: app.pages, scheduler: { background } });
  await app.reading.addFiles(app.files(...names(count)));
  const ids = () => app.store.photos.value.map(({ id }) => id);
  const shown = () => app.store.sheets.value.map(photosOfPage);
  const idle = () => {
    while (waiting.length > 0) waiting.shift()?.();
  };
  return { ...app, book, ids, shown, idle };
}
