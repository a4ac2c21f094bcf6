import { beforeEach, describe, expect, test } from 'vitest';
import { opened } from './book-testing.ts';
import type { PageDocument } from '../engine/types.ts';

let app: Awaited<ReturnType<typeof opened>>;
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

  test('reports photos that are on another page already, and only those', async () => {
    const { book, messages, shown } = await opened(7);
    book.add();
    const [first, second] = shown();
    const repeated = second.filter((photo) => first.includes(photo)).length;
    expect(messages.list.value.map(({ text }) => text)).toEqual([
      `There are not enough unused photos. This page repeats ${repeated} photos.`,
    ]);
    const { book: other, messages: quiet } = await opened(12);
    other.add();
    expect(quiet.list.value).toEqual([]);
  });

  test('is one step, which undo takes back', () => {
    const { book, pages, store } = app;
    const before = store.project.value;
    book.add();
    pages.undo();
    expect(store.project.value).toEqual(before);
    pages.redo();
    expect(store.sheets.value.length).toBe(2);
  });
});

describe('spreading the album', () => {
  test('puts every photo on one page, in order, in one style', async () => {
    const { book, store, shown, ids } = await opened(40, { byName: true });
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
    expect(store.project.value).toEqual(before);
  });

  test('keeps words on their photos', () => {
    const { book, store, ids } = app;
    const page = store.page.value as PageDocument;
    const photo = page.panels[5].photo;
    store.change({ type: 'change-page', page: { ...page, words: [{ kind: 'caption', text: 'Here', panel: 5 }] } });
    book.spreadAlbum();
    const found = store.sheets.value.flatMap(({ words, panels }) =>
      (words ?? []).map((word) => panels[word.panel ?? 0].photo),
    );
    expect(found).toEqual([photo]);
    expect(ids()).toContain(photo);
  });

  test('does nothing while the photos are locked', () => {
    const { book, pages, store } = app;
    pages.lock('photos', true);
    book.spreadAlbum();
    expect(store.sheets.value.length).toBe(1);
  });
});

describe('turning, moving, removing', () => {
  beforeEach(() => app.book.spreadAlbum());

  test('turning is no step, and an undo turns to what it changes', () => {
    const { book, pages, store } = app;
    const steps = store.mirror.value.undos;
    book.go(1);
    const before = store.page.value;
    pages.shuffle('style');
    book.go(0);
    expect(store.mirror.value.undos).toBe(steps + 1);
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
    expect(store.mirror.value.redos).toBe(1);
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

  test('the message about a removed page closes when the removal is undone, and not before', async () => {
    const { book, pages, messages } = app;
    book.remove();
    pages.shuffle('style');
    pages.undo();
    await Promise.resolve();
    expect(messages.list.value.map(({ text }) => text)).toEqual(['Page 1 was removed.']);
    pages.undo();
    await Promise.resolve();
    expect(messages.list.value).toEqual([]);
  });

  test('one style goes on all pages, as another version of those that had another', () => {
    const { book, store, pages } = app;
    pages.shuffle('style');
    expect(book.oneStyle.value).toBe(false);
    const { style } = store.page.value as PageDocument;
    book.styleAll();
    expect(store.sheets.value.map((page) => page.style)).toEqual([style, style]);
    pages.undo();
    expect(book.oneStyle.value).toBe(false);
  });
});
