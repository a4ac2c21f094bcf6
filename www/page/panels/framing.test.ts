import fc from 'fast-check';
import { expect, test } from 'vitest';
import { fitted, panned, zoomed } from './crop.ts';
import { createFraming } from './framing.ts';
import { fakeApp } from '../../document/testing.ts';
import type { Wish } from '../../engine/core.ts';
import type { PageDocument } from '../../engine/types.ts';
import type { Crop } from './crop.ts';

const part = fc.double({ min: 0.06, max: 1, noNaN: true });
const anyCrop = fc
  .record({
    width: part,
    height: part,
    u: fc.double({ min: 0, max: 1, noNaN: true }),
    v: fc.double({ min: 0, max: 1, noNaN: true }),
  })
  .map(({ width, height, u, v }) => ({ x: u * (1 - width), y: v * (1 - height), width, height }));
const anyMove = fc.double({ min: -3, max: 3, noNaN: true });

function isInside({ x, y, width, height }: Crop) {
  return x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= 1 + 1e-9 && y + height <= 1 + 1e-9;
}

test('however it is moved, no edge of the photo shows, and its shape stays', () => {
  fc.assert(
    fc.property(anyCrop, anyMove, anyMove, fc.double({ min: 0.01, max: 50, noNaN: true }), (crop, x, y, factor) => {
      const near = zoomed(panned(crop, x, y), factor);
      expect(isInside(near)).toBe(true);
      expect(near.width / near.height).toBeCloseTo(crop.width / crop.height, 6);
    }),
  );
});

test('the picture follows the hand, and a zoom holds the point under it', () => {
  const crop = { x: 0.3, y: 0.3, width: 0.4, height: 0.2 };
  expect(panned(crop, 0.5, -0.5)).toEqual({ x: expect.closeTo(0.1), y: expect.closeTo(0.4), width: 0.4, height: 0.2 });
  const near = zoomed(crop, 2, [0.25, 0.75]);
  expect(near.width).toBeCloseTo(0.2);
  expect(near.x + 0.25 * near.width).toBeCloseTo(crop.x + 0.25 * crop.width);
  expect(near.y + 0.75 * near.height).toBeCloseTo(crop.y + 0.75 * crop.height);
});

test('faces are fitted before things, with the aspect of the panel', () => {
  const photo = { width: 3000, height: 2000 };
  const face = { x: 0.6, y: 0.2, width: 0.1, height: 0.2, label: 'face', score: 0.6 };
  const dog = { x: 0.1, y: 0.5, width: 0.3, height: 0.3, label: 'dog', score: 0.9 };
  const crop = fitted([dog, face], photo, 0.8) as Crop;
  expect((crop.width * 3000) / (crop.height * 2000)).toBeCloseTo(0.8);
  expect(crop.x <= face.x && crop.x + crop.width >= face.x + face.width).toBe(true);
  expect(crop.width).toBeLessThan(0.4);
  expect(fitted([], photo, 1)).toBe(null);
});

async function app() {
  const made = fakeApp();
  await made.reading.addFiles(made.files('a', 'b', 'c', 'd'));
  const { store, pages } = made;
  const planner = made.planner as any;
  const panels = Array.from({ length: 4 }, (_, i) => ({ bounds: { x: i / 4, y: 0, width: 0.25, height: 1 } }));
  planner.geometry = () => ({ width: 1, height: 1, panels });
  // The core retains the current panels. The tests of the core check that.
  planner.planned = (page: PageDocument | null, { keep, current }: Wish) =>
    page && keep.photos && current ? { ...page, panels: current.panels } : page;
  const use = { photo: 'p1', crop: { x: 0.2, y: 0.2, width: 0.4, height: 0.4 } };
  const page = () => store.page.value as PageDocument;
  store.change({
    type: 'change-page',
    page: { ...page(), panels: ['p1', 'p2', 'p3', 'p4'].map((photo) => ({ ...use, photo })) },
  });
  return { ...made, page, framing: createFraming({ store, pages }) };
}

test('a pan is by hand, one step of the undo, and shared by merged panels', async () => {
  const { framing, store, page, pages } = await app();
  store.change({ type: 'change-page', page: { ...page(), merges: [[1, 2]] } });
  const steps = store.history.value.past.length;
  const crop = framing.cropOf(2) as Crop;
  const gesture = framing.step();
  framing.pan(2, crop, [0.1, 0], gesture);
  framing.pan(2, crop, [0.25, 0], gesture);
  expect(page().panels[1].crop?.x).toBeCloseTo(0.1);
  expect(page().panels[2]).toMatchObject({ edited: true, crop: page().panels[1].crop });
  expect(page().panels[0].edited).toBe(false);
  expect(store.history.value.past.length).toBe(steps + 1);
  framing.reset(1);
  expect(page().panels[1]).toMatchObject({ edited: false, crop: null });
  pages.undo();
  pages.undo();
  expect(page().panels[1].edited).toBe(false);
});

test('photos are swapped and replaced; a locked panel keeps its own', async () => {
  const { framing, page, pages } = await app();
  const photos = () => page().panels.map(({ photo }) => photo);
  framing.swap(0, 2);
  expect(photos()).toEqual(['p3', 'p2', 'p1', 'p4']);
  framing.toggle('swap', 1);
  framing.swapWith(3);
  expect(photos()).toEqual(['p3', 'p4', 'p1', 'p2']);
  expect(framing.mode.value).toBe(null);
  framing.replace(0, 'p2');
  expect(photos()).toEqual(['p2', 'p4', 'p1', 'p2']);
  pages.undo();
  expect(photos()[0]).toBe('p3');
  framing.lock(0, true);
  framing.replace(0, 'p2');
  framing.swap(0, 1);
  framing.pan(0, { x: 0, y: 0, width: 0.5, height: 0.5 }, [0.1, 0], 'x');
  expect(page().panels[0]).toMatchObject({ photo: 'p3', locked: true, edited: false });
});

test('a focus point belongs to the photo and is undone with the crops that it made', async () => {
  const { framing, store, pages } = await app();
  framing.focus(1, [0.5, 1]);
  const focusOf = (id: string) => store.photos.value.find((photo) => photo.id === id)?.focus;
  expect(focusOf('p2')).toEqual({ x: expect.closeTo(0.4), y: expect.closeTo(0.6) });
  expect(store.page.value?.panels[1].crop).toBe(null);
  pages.undo();
  expect(focusOf('p2')).toBe(null);
  expect(store.page.value?.panels[1].crop).not.toBe(null);
});
