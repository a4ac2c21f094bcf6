import { describe, expect, test, vi } from 'vitest';
import { createAlternatives } from '../page/alternatives.ts';
import { DARK_PAPER } from '../page/paper.ts';
import { fakeApp, orderByName } from './testing.ts';
import type { PageDocument, PhotoMeta } from '../engine/types.ts';
import type { Fact } from './album.ts';

vi.useFakeTimers();

async function opened() {
  const app = fakeApp();
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg'));
  return app;
}

test('new crops leave the frame of a missing photo as it is', async () => {
  const { pages, store } = await opened();
  const page = store.page.value as PageDocument;
  const [first, second] = page.panels;
  const missing = { hash: '', fingerprint: '', width: 4, height: 3, subjects: [], measured: true };
  for (const { photo } of [first, second]) {
    const fact = store.album.value.get(photo as string) as Fact;
    const meta = { ...(fact.meta as PhotoMeta), width: 1000, height: 4000 };
    store.know({ ...fact, meta, ...(photo === first.photo && { absent: missing }) });
  }
  pages.refine();
  const panels = (store.page.value as PageDocument).panels;
  expect(panels[0]).toEqual(first);
  expect(panels[1]).toMatchObject({ photo: second.photo });
  expect(panels[1].crop).not.toEqual(second.crop);
});

test('text is placed again in the undo step of the edit', async () => {
  const settled = (page: PageDocument) => ({
    ...page,
    words: page.words?.map((word) => ({ ...word, x: 0.5, y: 0.25 })),
  });
  const { pages, store, reading, files } = fakeApp({}, { settled });
  await reading.addFiles(files('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg'));
  store.change({ type: 'set-words', pages: [{ at: 0, words: [{ kind: 'caption', text: 'Here', panel: 0 }] }] });
  const before = store.project.value;
  let changes = -1;
  store.page.subscribe(() => {
    changes += 1;
  });
  expect(pages.edit({ type: 'swap-panels', panel: 0, with: 1 })).toBe(true);
  expect(store.page.value?.words?.[0]).toMatchObject({ text: 'Here', panel: 1, x: 0.5, y: 0.25 });
  expect(changes).toBe(1);
  pages.undo();
  expect(store.project.value).toEqual(before);
  expect(pages.edit({ type: 'swap-panels', panel: 0, with: 0 })).toBe(false);
});

describe('shuffle', () => {
  test('keeps what is locked', async () => {
    const { pages, planner, store } = await opened();
    const style = store.page.value?.style;
    pages.lock('style', true);
    pages.shuffle('all');
    expect(planner.wishes.at(-1)).toMatchObject({ type: 'shuffle', part: 'all' });
    expect(store.page.value?.style).toBe(style);
  });

  test('of photos puts them in other places', async () => {
    const { pages, store } = await opened();
    const places = () => store.page.value?.panels.map(({ photo }) => photo);
    for (let i = 0; i < 200; i += 1) {
      const before = places();
      pages.shuffle('photos');
      expect(places()).not.toEqual(before);
    }
  });

  test('of one part keeps the others', async () => {
    const { pages, planner, store } = await opened();
    const before = store.page.value as PageDocument;
    pages.shuffle('layout');
    expect(planner.wishes.at(-1)).toMatchObject({ type: 'shuffle', part: 'layout' });
    expect(store.page.value).toMatchObject({ style: before.style, order: before.order });
    const { layout } = store.page.value as PageDocument;
    pages.shuffle('photos');
    expect(store.page.value).toMatchObject({ layout, style: before.style });
  });

  test('of a locked part does nothing', async () => {
    const { pages, store } = await opened();
    pages.lock('layout', true);
    const before = store.page.value;
    pages.shuffle('layout');
    expect(store.page.value).toBe(before);
  });

  test('with locked photos asks for a place for each of them', async () => {
    const { pages, store } = await opened();
    const places = store.page.value?.panels.length;
    pages.lock('photos', true);
    pages.shuffle('all');
    expect(store.page.value?.panels.length).toBe(places);
  });

  test('respects the wanted number of panels, unless the layout stays', async () => {
    const { pages, store } = await opened();
    pages.wantPanels(2);
    expect(store.page.value?.panels.length).toBe(2);
    pages.shuffle('all');
    expect(store.page.value?.panels.length).toBe(2);
    pages.chooseLayout('grid-4');
    pages.shuffle('style');
    expect(store.page.value?.layout).toBe('grid-4');
  });
});

describe('settings', () => {
  test('change the page without another plan of its parts, and one drag is one step', async () => {
    const { pages, store } = await opened();
    const before = store.page.value as PageDocument;
    const steps = store.mirror.value.undos;
    for (const gutter of [0.02, 0.03, 0.04]) pages.changeSettings({ gutter }, 'gutter-0');
    const { layout, style, order, page } = store.page.value as PageDocument;
    expect([layout, style, order, page.gutter]).toEqual([before.layout, before.style, before.order, 0.04]);
    expect(store.mirror.value.undos).toBe(steps + 1);
  });

  test('hold for the next page', async () => {
    const { pages, store } = await opened();
    pages.changeSettings({ paper: '#ffcc00' });
    pages.shuffle('all');
    expect(store.page.value?.page.paper).toBe('#ffcc00');
  });
});

describe('walking', () => {
  test('previous and next lead through the pages shown, and stop at the ends', async () => {
    const { pages, store } = await opened();
    const first = store.page.value;
    pages.shuffle('all');
    const second = store.page.value;
    pages.next();
    expect(store.page.value).toBe(second);
    pages.previous();
    expect(store.page.value).toBe(first);
    pages.previous();
    expect(store.page.value).toBe(first);
    pages.next();
    expect(store.page.value).toBe(second);
  });

  test('shows none of a photo that left the table meanwhile', async () => {
    const { pages, store, reading } = await opened();
    pages.shuffle('all');
    const places = store.page.value?.panels.length;
    reading.remove('p1');
    pages.previous();
    const table = store.tray.value.map(({ id }) => id);
    expect(store.page.value?.panels.every(({ photo }) => photo !== null && table.includes(photo))).toBe(true);
    expect(store.page.value?.panels.length).toBe(places);
  });
});

describe('alternatives', () => {
  test('stay while one of them is chosen, and go when their basis goes', async () => {
    const { pages, store, reading, scheduler } = await opened();
    const alternatives = createAlternatives({ store, pages, scheduler });
    alternatives.more(5);
    const items = alternatives.items.value;
    expect(items.length).toBe(5);
    pages.show(items[2]);
    expect(alternatives.items.value).toBe(items);
    pages.lock('style', true);
    expect(alternatives.items.value).toEqual([]);
    pages.undo();
    alternatives.more(5);
    reading.use('p1', false);
    expect(alternatives.items.value).toEqual([]);
  });

  test('stay while text is added, written and removed', async () => {
    const { pages, store, scheduler } = await opened();
    const alternatives = createAlternatives({ store, pages, scheduler });
    alternatives.more(5);
    const items = alternatives.items.value;
    const page = store.page.value as PageDocument;
    for (const words of [[{ kind: 'caption', text: 'One', panel: 1 }], [{ kind: 'caption', text: 'Two' }], []])
      store.change({ type: 'change-page', page: { ...page, words } as PageDocument });
    expect(alternatives.items.value).toBe(items);
  });

  test('stay while a style changes the colours of the paper, and go when the user changes them', async () => {
    const { pages, store, scheduler } = await opened();
    const alternatives = createAlternatives({ store, pages, scheduler });
    alternatives.more(5);
    const items = alternatives.items.value;
    const shown = (colours: { paper: string; borderColor: string }) => {
      const page = store.page.value as PageDocument;
      pages.show({ ...page, page: { ...page.page, ...colours } });
    };
    shown(DARK_PAPER);
    expect(store.project.value.settings).toMatchObject(DARK_PAPER);
    expect(alternatives.items.value).toBe(items);
    shown({ ...DARK_PAPER, paper: '#f4efe6' });
    expect(alternatives.items.value).toEqual([]);
  });

  test('are not planned while a page is drawn', async () => {
    const { pages, planner, store, scheduler } = await opened();
    const alternatives = createAlternatives({ store, pages, scheduler });
    // Each plan takes longer than a frame.
    planner.planned = (page: PageDocument) => {
      vi.advanceTimersByTime(20);
      return page;
    };
    scheduler.hold(true);
    alternatives.more(5);
    await vi.advanceTimersByTimeAsync(2_000);
    expect(alternatives.items.value.length).toBe(1);
    scheduler.hold(false);
    await vi.advanceTimersByTimeAsync(2_000);
    expect(alternatives.items.value.length).toBe(5);
  });

  test('never repeat themselves, and end when there are no more', async () => {
    const { pages, store, scheduler } = await opened();
    orderByName({ store });
    const alternatives = createAlternatives({ store, pages, scheduler });
    pages.lock('style', true);
    pages.lock('layout', true);
    alternatives.more(5);
    expect(alternatives.items.value.length).toBe(1);
    alternatives.more(5);
    expect(alternatives.items.value.length).toBe(1);
  });
});
