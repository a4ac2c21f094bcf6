// @ts-check
import { beforeEach, describe, expect, test } from 'vitest';
import { createAlternatives } from './alternatives.js';
import { createBook } from './book.js';
import { keepBook } from './book-upkeep.js';
import { versions } from './history.js';
import { parsedProject, projectJson } from './keeping/project-json.js';
import { photosOf } from './keeping/snapshot.js';
import { checkedHistory } from './keeping/versions.js';
import { createShownPages } from './shown-pages.js';
import { balanced } from './spreading.js';
import { fakeApp } from './testing.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */

const names = (/** @type {number} */ count) => Array.from({ length: count }, (_, i) => `${i}.jpg`);
const photosOfPage = (/** @type {PageDocument} */ page) => page.panels.map(({ photo }) => photo);

/** A storyboard of one page, with so many photos. @param {number} count @param {Record<string, 'bad' | 'twin'>} [odd] */
async function opened(count, odd) {
  const app = fakeApp(odd);
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

/** @type {Awaited<ReturnType<typeof opened>>} */
let app;
beforeEach(async () => {
  app = await opened(12);
});

describe('adding a page', () => {
  test('takes photos that no other page shows, behind the page, in its style, and turns to it', () => {
    const { book, store, shown } = app;
    const [first] = store.sheets.value;
    book.add();
    expect(store.sheets.value.length).toBe(2);
    expect(store.project.value.at).toBe(1);
    expect(store.page.value?.style).toEqual(first.style);
    expect(shown()[1].filter((photo) => shown()[0].includes(photo))).toEqual([]);
    book.go(0);
    book.add();
    expect(store.project.value.at).toBe(1);
  });

  test('takes any when too few are left', async () => {
    const { book, store } = await opened(7);
    book.add();
    expect(store.sheets.value[1].panels.length).toBeGreaterThan(1);
  });

  test('is one step, which undo takes back', () => {
    const { book, pages, store } = app;
    const before = store.project.value;
    book.add();
    pages.undo();
    expect(store.project.value).toBe(before);
    pages.redo();
    expect(store.sheets.value.length).toBe(2);
  });
});

describe('spreading the album', () => {
  test('puts every photo on one page, in order, in one style', async () => {
    const { book, store, shown, ids } = await opened(40);
    const style = store.page.value?.style;
    book.spreadAlbum();
    expect(shown().flat()).toEqual(ids());
    expect(store.sheets.value.length).toBe(7);
    expect(store.sheets.value.every((page) => page.style === style)).toBe(true);
    expect(book.left.value).toEqual([]);
  });

  test('takes the wanted number of panels', () => {
    const { book, pages, shown } = app;
    pages.wantPanels(4);
    book.spreadAlbum();
    expect(shown().map((photos) => photos.length)).toEqual([4, 4, 4]);
  });

  test('is undone as one step', () => {
    const { book, pages, store } = app;
    const before = store.project.value;
    book.spreadAlbum();
    pages.undo();
    expect(store.project.value).toBe(before);
  });

  test('keeps words on their photos', () => {
    const { book, store, ids } = app;
    const page = /** @type {PageDocument} */ (store.page.value);
    const photo = page.panels[5].photo;
    store.change({ type: 'change-page', page: { ...page, words: [{ kind: 'caption', text: 'Here', panel: 5 }] } });
    book.spreadAlbum();
    const found = store.sheets.value.flatMap(({ words, panels }) => (words ?? []).map((word) => panels[word.panel ?? 0].photo));
    expect(found).toEqual([photo]);
    expect(ids()).toContain(photo);
  });

  test('does nothing while the photos are locked', () => {
    const { book, pages, store } = app;
    pages.lock('photos', true);
    book.spreadAlbum();
    expect(store.sheets.value.length).toBe(1);
  });

  test('leaves no page with much less than the others', () => {
    for (let count = 1; count < 100; count += 1) {
      const sizes = balanced(count, 6, [1, 2, 3, 4, 5, 6]);
      expect(sizes.reduce((sum, size) => sum + size, 0)).toBe(count);
      expect(Math.max(...sizes)).toBeLessThanOrEqual(6);
      expect(Math.max(...sizes) - Math.min(...sizes)).toBeLessThanOrEqual(1);
    }
  });

  test('counts on layouts that there are', () => {
    expect(balanced(13, 6, [2, 4])).toEqual([4, 4, 4, 1]);
    expect(balanced(5, 6, [])).toEqual([5]);
  });
});

describe('turning, moving, removing', () => {
  beforeEach(() => app.book.spreadAlbum());

  test('turning is no step, and an undo turns to what it changes', () => {
    const { book, pages, store } = app;
    const steps = store.history.value.past.length;
    book.go(1);
    const before = store.page.value;
    pages.shuffle('style');
    book.go(0);
    expect(store.history.value.past.length).toBe(steps + 1);
    pages.undo();
    expect(store.project.value.at).toBe(1);
    expect(store.page.value).toBe(before);
  });

  test('turning stops at the ends, and leaves what can be redone', () => {
    const { book, pages, store } = app;
    pages.shuffle('style');
    pages.undo();
    book.step(-1);
    book.step(5);
    expect(store.project.value.at).toBe(0);
    book.step(1);
    expect(store.project.value.at).toBe(1);
    expect(store.history.value.future.length).toBe(1);
  });

  test('a moved page is elsewhere in the order, and the page that is edited stays it', () => {
    const { book, store } = app;
    const [one, two] = store.sheets.value;
    book.move(0, 1);
    expect(store.sheets.value).toEqual([two, one]);
    expect(store.page.value).toBe(one);
    book.move(0, 1);
    expect(store.page.value).toBe(one);
    expect(store.project.value.at).toBe(0);
  });

  test('a removed page is followed by its neighbour, and its photos are free', () => {
    const { book, store, pages } = app;
    const [one, two] = store.sheets.value;
    book.go(1);
    book.remove();
    expect(store.sheets.value).toEqual([one]);
    expect(book.left.value.length).toBe(two.panels.length);
    book.remove();
    expect(store.sheets.value).toEqual([one]);
    pages.undo();
    expect(store.sheets.value).toEqual([one, two]);
  });

  test('what a message offers to bring back comes back, whatever was done since', () => {
    const { book, store, pages, messages } = app;
    const [, two] = store.sheets.value;
    book.go(1);
    book.remove();
    pages.shuffle('style');
    const styled = store.page.value;
    messages.list.value.at(-1)?.way?.run();
    expect(store.sheets.value).toEqual([styled, two]);
    messages.list.value.at(-1)?.way?.run();
    expect(store.sheets.value.length).toBe(2);
  });

  test('one style goes on all pages, as another version of those that had another', () => {
    const { book, store, pages } = app;
    pages.shuffle('style');
    expect(book.oneStyle.value).toBe(false);
    const { style } = /** @type {PageDocument} */ (store.page.value);
    book.styleAll();
    expect(store.sheets.value.map((page) => page.style)).toEqual([style, style]);
    pages.undo();
    expect(book.oneStyle.value).toBe(false);
  });
});

describe('photos among pages', () => {
  test('a shuffle takes those that no other page shows', () => {
    const { book, pages, shown, store } = app;
    book.add();
    pages.wantPanels(3);
    for (let i = 0; i < 5; i += 1) {
      pages.shuffle('photos');
      expect(shown()[1].filter((photo) => shown()[0].includes(photo))).toEqual([]);
    }
    book.spreadAlbum();
    const own = shown()[0];
    pages.wantPanels(null);
    pages.shuffle('all');
    expect([...shown()[0]].sort()).toEqual([...own].sort());
    expect(store.sheets.value.length).toBe(4);
  });

  test('a page that wants more than there are takes from all', () => {
    const { book, pages, shown, planner } = app;
    book.spreadAlbum();
    pages.wantPanels(6);
    pages.chooseLayout('l6');
    expect(shown()[0].length).toBe(6);
    book.remove();
    pages.wantPanels(3);
    expect(planner.requests.at(-1)?.photos.length).toBe(12);
  });

  test('the alternatives of a page have its photos', () => {
    const { book, store, pages, planner } = app;
    book.spreadAlbum();
    const alternatives = createAlternatives({ store, pages });
    const first = alternatives.basis.value;
    alternatives.more(1);
    expect(planner.requests.at(-1)?.photos.length).toBe(6);
    book.go(1);
    expect(alternatives.basis.value).not.toBe(first);
  });

  test('one that is removed leaves the other pages, without a step of its own', () => {
    const { book, reading, store, shown, pages } = app;
    book.spreadAlbum();
    book.go(1);
    const before = store.project.value;
    const [gone] = /** @type {string[]} */ (shown()[0]);
    const here = shown()[1];
    reading.remove(gone);
    expect(shown().flat()).not.toContain(gone);
    expect(shown()[0].length).toBeLessThan(6);
    expect(shown()[1]).toEqual(here);
    pages.undo();
    expect(store.project.value).toBe(before);
    pages.redo();
    expect(shown().flat()).not.toContain(gone);
  });

  test('a page that no photo is left for goes', () => {
    const { book, store, pages } = app;
    book.spreadAlbum();
    book.go(1);
    const gone = photosOfPage(store.sheets.value[0]);
    store.change({ type: 'remove-photos', ids: /** @type {string[]} */ (gone) });
    expect(store.sheets.value.length).toBe(1);
    pages.undo();
    expect(store.sheets.value.length).toBe(2);
  });

  test('photos that are added go to no page by themselves', async () => {
    const { book, reading, files, store } = app;
    book.spreadAlbum();
    const before = store.sheets.value;
    await reading.addFiles(files('new.jpg'));
    expect(store.sheets.value).toEqual(before);
    expect(book.left.value.length).toBe(1);
  });

  test('a frame in the place of another is it on all pages', () => {
    const { book, store, shown } = app;
    book.spreadAlbum();
    const [old] = /** @type {string[]} */ (shown()[1]);
    const fact = /** @type {any} */ (store.album.value.get(old));
    store.know({ ...fact, id: 'fresh', meta: { ...fact.meta, id: 'fresh' } });
    store.change({ type: 'exchange-photo', id: old, by: 'fresh' });
    expect(shown()[1][0]).toBe('fresh');
  });

  test('what is found in a photo reaches the crops of other pages later, without a step', () => {
    const { book, store, planner, shown, idle } = app;
    book.spreadAlbum();
    const steps = store.history.value.past.length;
    const [id] = /** @type {string[]} */ (shown()[1]);
    const fact = /** @type {any} */ (store.album.value.get(id));
    const asked = planner.requests.length;
    store.know({ ...fact, meta: { ...fact.meta, subjects: [{ label: 'face', score: 1, x: 0, y: 0, width: 0.1, height: 0.1 }] } });
    expect(planner.requests.length).toBe(asked);
    idle();
    expect(planner.requests.length).toBe(asked + 1);
    expect(planner.requests.at(-1)?.current).toEqual(store.sheets.value[1]);
    expect(store.history.value.past.length).toBe(steps);
    idle();
    expect(planner.requests.length).toBe(asked + 1);
  });
});

describe('page settings', () => {
  test('are of all pages, as one step', () => {
    const { book, pages, store } = app;
    book.spreadAlbum();
    const steps = store.history.value.past.length;
    for (const gutter of [0.02, 0.03]) pages.changeSettings({ gutter }, 'gutter-1');
    pages.changeSettings({ width: 2000 });
    expect(store.sheets.value.map(({ page }) => [page.gutter, page.width])).toEqual([[0.03, 2000], [0.03, 2000]]);
    expect(store.history.value.past.length).toBe(steps + 2);
    pages.undo();
    pages.undo();
    expect(store.sheets.value.map(({ page }) => page.gutter)).toEqual([0.018, 0.018]);
  });

  test('hold for a version that comes back', () => {
    const { book, pages, store } = app;
    book.spreadAlbum();
    pages.shuffle('all');
    pages.changeSettings({ paper: '#ffcc00' });
    pages.previous();
    expect(store.page.value?.page.paper).toBe('#ffcc00');
  });
});

describe('versions', () => {
  test('are of the page that is edited', () => {
    const { book, pages, store } = app;
    book.spreadAlbum();
    book.go(1);
    const first = store.page.value;
    pages.shuffle('style');
    book.go(0);
    book.go(1);
    expect(versions(store.history.value).length).toBe(2);
    pages.previous();
    expect(store.page.value).toEqual(first);
    const others = store.project.value.others;
    pages.previous();
    expect(store.page.value).toEqual(first);
    expect(store.project.value.others).toEqual(others);
  });

  test('come back in the place that they belong to', () => {
    const { book, pages, store } = app;
    const shownPages = createShownPages(app);
    book.spreadAlbum();
    book.go(1);
    const [one, two] = store.sheets.value;
    pages.shuffle('style');
    book.go(0);
    const entry = shownPages.entries.value.find(({ page }) => page === two);
    expect(entry?.place).toBe(2);
    shownPages.go(Number(entry?.id));
    expect(store.project.value.at).toBe(1);
    expect(store.sheets.value).toEqual([one, two]);
  });
});

describe('keeping', () => {
  test('keeps the pages and their photos, in the browser and in a file', () => {
    const { book, store, ids } = app;
    book.spreadAlbum();
    const { gesture: _gesture, ...history } = store.history.value;
    expect([...photosOf({ ...history, shown: [], past: [] })].sort()).toEqual(ids().sort());
    expect(checkedHistory(structuredClone(history)).present).toEqual(store.project.value);
    const facts = /** @type {any[]} */ (store.facts.value.map((fact) => ({ ...fact, type: 'image/jpeg' })));
    const { history: opened } = parsedProject(projectJson(history, facts, []).json);
    expect(opened.present.others).toEqual(store.project.value.others);
  });

  test('a project from before has one page', () => {
    const { others: _others, at: _at, sheet: _sheet, ...old } = app.store.project.value;
    expect(checkedHistory({ present: old }).present).toMatchObject({ others: [], at: 0, sheet: 0 });
  });

  test('a damaged page is named', () => {
    const present = { ...app.store.project.value, others: [{ page: {}, pageId: 1, sheet: 1 }] };
    expect(() => checkedHistory({ present })).toThrow('present.others[0].page: is no page');
    expect(() => checkedHistory({ present: { ...app.store.project.value, at: 3 } })).toThrow('present.at');
  });
});

