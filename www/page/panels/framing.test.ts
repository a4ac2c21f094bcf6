import { expect, test } from 'vitest';
import { createFraming } from './framing.ts';
import { fakeApp } from '../../document/testing.ts';
import type { Bounds, PageDocument } from '../../engine/types.ts';

async function app() {
  const made = fakeApp();
  await made.reading.addFiles(made.files('a', 'b', 'c', 'd'));
  const { store, pages } = made;
  pages.chooseLayout('grid-4');
  const page = () => store.page.value as PageDocument;
  const framing = createFraming({ store, pages });
  for (const [panel, photo] of ['p1', 'p2', 'p3', 'p4'].entries()) framing.replace(panel, photo);
  return { ...made, page, framing };
}

test('a pan is by hand, one step of the undo, and shared by merged panels', async () => {
  const { framing, store, page, pages } = await app();
  pages.edit({ type: 'merge-panels', panels: [0, 1] });
  const steps = store.mirror.value.undos;
  framing.closer(1, 2, 'zoom');
  const crop = framing.cropOf(1) as Bounds;
  const gesture = framing.step();
  framing.pan(1, crop, [0.1, 0], gesture);
  framing.pan(1, crop, [0.25, 0], gesture);
  expect(page().panels[0].crop?.x).toBeCloseTo(crop.x - 0.25 * crop.width);
  expect(page().panels[1]).toMatchObject({ edited: true, crop: page().panels[0].crop });
  expect(page().panels[2].edited).toBe(false);
  expect(store.mirror.value.undos).toBe(steps + 2);
  framing.reset(0);
  expect(page().panels[1].edited).toBe(false);
  pages.undo();
  expect(page().panels[1].edited).toBe(true);
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
  const { framing, store, pages, page } = await app();
  const before = page().panels[1].crop as Bounds;
  framing.closer(1, 1.5);
  const crop = framing.cropOf(1) as Bounds;
  framing.focus(1, [0.5, 1]);
  const focusOf = (id: string) => store.photos.value.find((photo) => photo.id === id)?.focus;
  const [x, y] = [crop.x + crop.width / 2, crop.y + crop.height];
  expect(focusOf('p2')).toEqual({ x: expect.closeTo(x), y: expect.closeTo(y) });
  expect(page().panels[1]).toMatchObject({ edited: false, crop: { width: before.width } });
  pages.undo();
  expect(focusOf('p2')).toBe(null);
  expect(page().panels[1]).toMatchObject({ edited: true, crop });
});
