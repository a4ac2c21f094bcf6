import { beforeEach, describe, expect, test } from 'vitest';
import { createAlternatives } from '../page/alternatives.ts';
import { opened, photosOfPage } from './book-testing.ts';

let app: Awaited<ReturnType<typeof opened>>;
beforeEach(async () => {
  app = await opened(12);
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
    const { book, pages, shown } = app;
    book.spreadAlbum();
    pages.wantPanels(6);
    pages.chooseLayout('grid-6');
    expect(shown()[0].length).toBe(6);
  });

  test('the alternatives of a page have its photos', () => {
    const { book, store, pages, shown, scheduler } = app;
    book.spreadAlbum();
    const alternatives = createAlternatives({ store, pages, scheduler });
    const first = alternatives.basis.value;
    alternatives.more(1);
    const own = new Set(shown()[0]);
    expect(alternatives.items.value[0].panels.every(({ photo }) => own.has(photo))).toBe(true);
    book.go(1);
    expect(alternatives.basis.value).not.toBe(first);
  });

  test('one that is removed leaves the other pages, without a step of its own', () => {
    const { book, reading, store, shown, pages } = app;
    book.spreadAlbum();
    book.go(1);
    const before = store.project.value;
    const [gone] = shown()[0] as string[];
    const here = shown()[1];
    reading.remove(gone);
    expect(shown().flat()).not.toContain(gone);
    expect(shown()[0].length).toBeLessThan(6);
    expect(shown()[1]).toEqual(here);
    pages.undo();
    expect(store.project.value).toEqual(before);
    pages.redo();
    expect(shown().flat()).not.toContain(gone);
  });

  test('a page that no photo is left for goes', () => {
    const { book, store, pages } = app;
    book.spreadAlbum();
    book.go(1);
    const gone = photosOfPage(store.sheets.value[0]);
    store.change({ type: 'remove-photos', ids: gone as string[] });
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
    const [old] = shown()[1] as string[];
    const fact = store.album.value.get(old) as any;
    store.know({ ...fact, id: 'fresh', meta: { ...fact.meta, id: 'fresh' } });
    store.change({ type: 'exchange-photo', id: old, by: 'fresh' });
    expect(shown()[1][0]).toBe('fresh');
  });

  test('what is found in a photo reaches the crops of other pages later, without a step', () => {
    const { book, store, planner, shown, idle } = app;
    book.spreadAlbum();
    const steps = store.mirror.value.undos;
    const [id] = shown()[1] as string[];
    const before = store.sheets.value[1];
    const fact = store.album.value.get(id) as any;
    const asked = () => planner.wishes.filter(({ type }) => type === 'recrop').length;
    const first = asked();
    store.know({
      ...fact,
      meta: { ...fact.meta, subjects: [{ label: 'face', score: 1, x: 0, y: 0, width: 0.1, height: 0.1 }] },
    });
    expect(asked()).toBe(first);
    idle();
    expect(asked()).toBe(first + 1);
    expect(store.sheets.value[1].panels[0].crop).not.toEqual(before.panels[0].crop);
    expect(store.mirror.value.undos).toBe(steps);
    idle();
    expect(asked()).toBe(first + 1);
  });
});
