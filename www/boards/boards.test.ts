import { expect, test } from 'vitest';
import { fakeApp } from '../document/testing.ts';
import { createBoards } from './boards.ts';
import type { PageDocument, Word } from '../engine/types.ts';

test('films of one name are listed by their keys, with the timecodes of their cameras', () => {
  const { store } = fakeApp();
  const start = { frame: 900_000, fps: 25, drop: false };
  const film = (key: string, timecode?: typeof start) => {
    const file = new File([], 'C0001.MP4');
    return { key, name: file.name, file, ids: [], duration: 2, start: 0, end: 2, timecode };
  };
  store.videos.value = new Map([
    ['a', film('a', start)],
    ['b', film('b')],
  ]);
  store.know({ id: 'p1', name: 'one', meta: null, measures: null, video: 'a', time: 0.96 });
  store.know({ id: 'p2', name: 'two', meta: null, measures: null, video: 'b', time: 1.2 });
  store.know({ id: 'p3', name: 'photo', meta: null, measures: null });
  store.change({ type: 'add-photos', ids: ['p1', 'p2', 'p3'], silent: true });
  const { shots } = createBoards({ store, engine: {} as any, chooseStyle: () => {} }).shotList();
  expect(shots.map(({ name, film }) => [name, film])).toEqual([
    ['one', { key: 'a', name: 'C0001.MP4', time: 0.96, length: 2, timecode: start }],
    ['two', { key: 'b', name: 'C0001.MP4', time: 1.2, length: 2, timecode: undefined }],
    ['photo', undefined],
  ]);
});

test('the shots follow the pages, with their text in columns by kind, and unused photos come last', async () => {
  const app = fakeApp();
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg'));
  const { store } = app;
  const [a, b, c, d] = store.photos.value.map(({ id }) => id);
  const page = store.page.value as PageDocument;
  const words = [
    { kind: 'balloon', text: 'And *you*?', panel: 0, x: 0.5, y: 0.8 },
    { kind: 'caption', text: 'Later', panel: 0, x: 0.2, y: 0.1 },
    { kind: 'effect', text: 'BANG', panel: 0, x: 0.5, y: 0.5 },
    { kind: 'balloon', text: 'Me?', panel: 1, x: 0.5, y: 0.5, by: 'Ann' },
    { kind: 'balloon', text: 'You.', panel: 1, x: 0.5, y: 0.9, by: 'grandma rose' },
  ] as Word[];
  const panels = [c, a].map((photo) => ({ ...page.panels[0], photo }));
  store.change({ type: 'change-page', page: { ...page, layout: 'grid-2', panels, words, merges: [] } });
  const boards = createBoards({ store, engine: {} as any, chooseStyle: () => {} });
  expect(boards.rows.value.map(({ id }) => id)).toEqual([c, a, b, d]);
  const said = () => boards.shotList().shots.map(({ dialogue, caption, sound }) => [dialogue, caption, sound]);
  const nothing = ['', '', ''];
  expect(said()).toEqual([['And you?', 'Later', 'BANG'], ['Ann: Me?\nGrandma Rose: You.', '', ''], nothing, nothing]);
  boards.put({ row: 1, column: boards.columns.value.findIndex(({ id }) => id === 'dialogue') }, [['Mine']]);
  expect(said()).toEqual([['And you?', 'Later', 'BANG'], ['Mine', '', ''], nothing, nothing]);
  // A shot that was dragged stays there until the order follows the pages again.
  boards.move(3, 0);
  expect(boards.rows.value.map(({ id }) => id)).toEqual([d, c, a, b]);
  boards.followPages();
  expect(boards.rows.value.map(({ id }) => id)).toEqual([c, a, b, d]);
});
