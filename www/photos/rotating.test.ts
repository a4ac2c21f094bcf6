import { expect, test } from 'vitest';
import { opened, photosOfPage } from '../book/book-testing.ts';
import { createRotating } from './rotating.ts';
import type { Rotation } from '../engine/metadata/rotate.ts';

async function app() {
  const made = await opened(12, { byName: true });
  const { store, pages, reading, engine, messages } = made;
  const files: { id: string; rotation: Rotation }[] = [];
  engine.rotatedPhoto = async (id: string, rotation: Rotation) => {
    files.push({ id, rotation });
    return new Blob([rotation]);
  };
  const rotating = createRotating({ store, pages, reading, engine, messages });
  const photoAt = (panel: number) => store.page.value?.panels[panel].photo as string;
  return { ...made, rotating, rotated: files, photoAt };
}

test('a rotated photo replaces the photo in the tray and on the page, as one step', async () => {
  const { store, pages, rotating, engine, rotated, photoAt } = await app();
  const [before, id] = [store.project.value, photoAt(1)];
  const place = store.tray.value.findIndex((item) => item.id === id);
  store.change({ type: 'star-photo', id, on: true });
  const steps = store.mirror.value.undos;
  await rotating.rotate(() => id, 'right');
  const fresh = photoAt(1);
  expect(rotated).toEqual([{ id, rotation: 'right' }]);
  expect(fresh).not.toBe(id);
  expect(store.tray.value.map((item) => item.id)).not.toContain(id);
  expect(store.tray.value[place]).toMatchObject({ id: fresh, starred: true });
  expect(store.album.value.get(fresh)?.name).toBe(store.album.value.get(id)?.name);
  expect(engine.files.get(fresh).name).toBe(store.album.value.get(id)?.name);
  expect(store.mirror.value.undos - steps).toBe(1);
  pages.undo();
  pages.undo();
  expect(store.project.value.page).toEqual(before.page);
  expect(store.project.value.tray).toEqual(before.tray);
});

test('its subjects and its focus point turn with it', async () => {
  const { store, rotating, photoAt } = await app();
  const id = photoAt(0);
  const fact = store.album.value.get(id) as any;
  const face = {
    label: 'face',
    score: 1,
    x: 0.1,
    y: 0.2,
    width: 0.3,
    height: 0.4,
    points: Array(6).fill([0.2, 0.3]),
    expression: { rightEye: 0.3, leftEye: 0.1, mouth: 0, smile: 0.1 },
  };
  store.know({ ...fact, meta: { ...fact.meta, taken: '2020:01:01 00:00:00', subjects: [face] } });
  store.change({ type: 'focus-photo', id, focus: { x: 0.1, y: 0.2 } });
  await rotating.rotate(() => id, 'right');
  const [turned] = store.album.value.get(photoAt(0))?.meta?.subjects ?? [];
  const near = (value: number) => expect.closeTo(value, 9);
  expect(turned).toMatchObject({ label: 'face', x: near(0.4), y: near(0.1), width: near(0.4), height: near(0.3) });
  expect(turned.points).toEqual(Array(6).fill([near(0.7), near(0.2)]));
  expect(turned.expression).toEqual(face.expression);
  expect(store.album.value.get(photoAt(0))?.meta?.taken).toBe('2020:01:01 00:00:00');
  const focusOf = () => store.tray.value.find((item) => item.id === photoAt(0))?.focus;
  expect(focusOf()).toEqual({ x: near(0.8), y: near(0.1) });
  await rotating.rotate(() => photoAt(0), 'flip');
  const flipped = store.album.value.get(photoAt(0))?.meta?.subjects[0];
  expect(flipped).toMatchObject({
    x: near(0.2),
    y: near(0.1),
    expression: { rightEye: 0.1, leftEye: 0.3, smile: 0.1 },
  });
  expect(focusOf()).toEqual({ x: near(0.2), y: near(0.1) });
});

test('its crops are computed again on all pages', async () => {
  const { store, book, rotating } = await app();
  book.spreadAlbum();
  book.go(0);
  const [, second] = store.sheets.value;
  const id = photosOfPage(second)[0] as string;
  const crop = { x: 0.1, y: 0.1, width: 0.2, height: 0.3 };
  const panels = second.panels.map((use, i) => (i === 0 ? { ...use, crop, edited: true } : use));
  const { others, page, pageId, at } = store.project.value;
  const sheet = { page: page as any, pageId, sheet: store.project.value.sheet };
  store.change({
    type: 'set-sheets',
    sheets: [sheet, { ...others[0], page: { ...second, panels } }, ...others.slice(1)] as any,
    at,
  });
  await rotating.rotate(() => id, 'right');
  const after = store.sheets.value[1].panels[0];
  expect(after.photo).not.toBe(id);
  expect(after.edited).toBe(false);
  expect(after.crop).not.toEqual(crop);
});

test('rotations that follow each other quickly add up, and each is a step', async () => {
  const { store, rotating, rotated, photoAt } = await app();
  const steps = store.mirror.value.undos;
  const done = [rotating.rotate(() => photoAt(0), 'right'), rotating.rotate(() => photoAt(0), 'right')];
  expect(rotating.busy()).toBe(true);
  await Promise.all(done);
  expect(rotating.busy()).toBe(false);
  expect(rotated.length).toBe(2);
  expect(rotated[1].id).not.toBe(rotated[0].id);
  expect(store.mirror.value.undos - steps).toBe(2);
});

test('a photo that cannot be rotated is named, and nothing changes', async () => {
  const { store, rotating, engine, messages, photoAt } = await app();
  engine.rotatedPhoto = () => Promise.reject(Object.assign(new Error('bad'), { code: 'damaged' }));
  const before = store.project.value;
  await rotating.rotate(() => photoAt(0), 'flip');
  expect(store.project.value).toBe(before);
  expect(JSON.stringify(messages)).toContain(store.album.value.get(photoAt(0))?.name);
  expect(rotating.busy()).toBe(false);
});

test('the tile of a photo rotates what the photo has become, also after undo', async () => {
  const { store, pages, rotating, rotated, photoAt } = await app();
  const id = photoAt(0);
  const [first, second] = await Promise.all([rotating.rotate(() => id, 'right'), rotating.rotate(() => id, 'right')]);
  expect(rotated.map((one) => one.id)).toEqual([id, first]);
  expect([photoAt(0), await rotating.rotate(() => 'none', 'right')]).toEqual([second, undefined]);
  pages.undo();
  pages.undo();
  const third = await rotating.rotate(() => id, 'right');
  expect([rotated.at(-1)?.id, photoAt(0), store.album.value.get(third ?? '')?.name]).toEqual([
    id,
    third,
    store.album.value.get(id)?.name,
  ]);
});
