import { expect, test } from 'vitest';
import { fakeApp } from '../document/testing.ts';
import { createBoards } from './boards.ts';

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
