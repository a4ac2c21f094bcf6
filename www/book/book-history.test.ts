import { beforeEach, describe, expect, test } from 'vitest';
import { opened } from './book-testing.ts';
import { projectJson } from '../storage/files/project-json.ts';
import { photosOf } from '../storage/snapshot.ts';
import { createShownPages } from './shown-pages.ts';

let app: Awaited<ReturnType<typeof opened>>;
beforeEach(async () => {
  app = await opened(12);
});

describe('page settings', () => {
  test('are of all pages, as one step', () => {
    const { book, pages, store } = app;
    book.spreadAlbum();
    const steps = store.mirror.value.undos;
    for (const gutter of [0.02, 0.03]) pages.changeSettings({ gutter }, 'gutter-1');
    pages.changeSettings({ width: 2000 });
    expect(store.sheets.value.map(({ page }) => [page.gutter, page.width])).toEqual([
      [0.03, 2000],
      [0.03, 2000],
    ]);
    expect(store.mirror.value.undos).toBe(steps + 2);
    pages.undo();
    pages.undo();
    expect(store.sheets.value.map(({ page }) => page.gutter)).toEqual([0.018, 0.018]);
  });

  test('while a slider is held are of the page that is shown, and of all pages once it is let go, as one step', () => {
    const { book, pages, store } = app;
    book.spreadAlbum();
    const steps = store.mirror.value.undos;
    const gutters = () => store.sheets.value.map(({ page }) => page.gutter);
    for (const gutter of [0.02, 0.03]) pages.changeSettings({ gutter }, 'gutter-1', { held: true });
    expect(gutters()).toEqual([0.03, 0.018]);
    pages.changeSettings({}, 'gutter-1');
    expect(gutters()).toEqual([0.03, 0.03]);
    expect(store.mirror.value.undos).toBe(steps + 1);
    pages.undo();
    expect(gutters()).toEqual([0.018, 0.018]);
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
    expect(store.versions.value.length).toBe(2);
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
    const history = store.mirror.value;
    expect([...photosOf([history.present])].sort()).toEqual(ids().sort());
    const facts = store.facts.value.map((fact) => ({ ...fact, type: 'image/jpeg' })) as any[];
    const { history: opened } = JSON.parse(projectJson(history, facts, []).json);
    expect(opened.present.others).toEqual(store.project.value.others);
  });
});
