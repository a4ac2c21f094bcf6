import { expect, it } from 'vitest';
import { createLru } from './lru.ts';
import { createOperations } from './operations.ts';
import type { Studio } from '../pkg/inkpanel.js';
import type { Imported } from './protocol.ts';

const slow = () => {};

/** A studio that records its photos, each with a hundred bytes per copy. */
function studio() {
  const there = new Set<string>();
  const work = {
    there,
    import_draft: (id: string, bytes: Uint8Array) => (bytes.length === 0 ? undefined : work.import_frame(id)),
    import_frame: (id: string) => {
      for (const tier of ['work', 'small']) there.add(`${id}/${tier}`);
      const size = { width: 5, height: 5 };
      return JSON.stringify({ meta: { id }, format: 'png', measures: {}, work: size, small: size });
    },
    take_file: () => new Uint8Array(10),
    photo_planes: () => new Uint8Array(100),
    has_photo: (key: string) => there.has(key),
    put: [] as string[],
    put_photo: (key: string) => {
      work.put.push(key);
      there.add(key);
    },
    drop_photo: (key: string) => there.delete(key),
    know_subject: () => {},
    render_panel: () => [{ x: 0, y: 0, width: 1, height: 1, take: () => new Uint8ClampedArray(4), free: () => {} }],
  };
  return work;
}

it('holds few of the frames of a film that nobody shows, and those that are shown as photos are held', async () => {
  const work = studio();
  const operations = createOperations(work as unknown as Studio, createLru(1000), createLru(400));
  const imported = async (id: string) => {
    const frame = { width: 5, height: 5, squareWidth: 5, squareHeight: 5, rotation: 0, data: new Uint8Array(100) };
    return (await operations.importFrame({ id, frame }, slow)).ok as Imported;
  };
  const shown = await imported('a');
  await operations.front({ document: '{}', pictures: [0], width: 10, tier: 'work', photos: [shown.work] }, slow);
  for (const id of ['b', 'c', 'd', 'e', 'f']) await imported(id);
  expect([...work.there]).toEqual(['a/work', 'e/work', 'e/small', 'f/work', 'f/small']);
  // A removed photo is read again.
  const again = await imported('g');
  work.drop_photo('g/work');
  await operations.front({ document: '{}', pictures: [0], width: 10, tier: 'work', photos: [again.work] }, slow);
  expect(work.there.has('g/work')).toBe(true);
});

it('replaces a draft by the photo when a picture of it is wanted, and not the other way round', async () => {
  const work = studio();
  const operations = createOperations(work as unknown as Studio, createLru(1000), createLru(400));
  const small = (await operations.draft({ id: 'a', file: new Blob([]) }, slow)).ok;
  expect(small).toBe(null);
  const { work: draft } = (await operations.draft({ id: 'a', file: new Blob(['x']) }, slow)).ok as Imported;
  expect(draft).toMatchObject({ key: 'a/work', draft: true });
  const drawn = (photo: Imported['work']) =>
    operations.front({ document: '{}', pictures: [0], width: 10, tier: 'work', photos: [photo] }, slow);
  await drawn(draft);
  expect(work.put).toEqual([]);
  // Another worker has read the photo.
  const { draft: _, ...photo } = draft;
  await drawn(photo);
  expect(work.put).toEqual(['a/work']);
  await drawn(photo);
  await drawn(draft);
  expect(work.put).toEqual(['a/work']);
});
