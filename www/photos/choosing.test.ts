import { expect, test, vi } from 'vitest';
import { createChoosing, exchanged, resorted } from './choosing.ts';
import { fakeApp } from '../document/testing.ts';
import { strings } from '../strings/strings.ts';
import { enlarged } from '../page/panels/enlarging.ts';
import type { PageDocument } from '../document/project.ts';

const names = ({ store }: ReturnType<typeof fakeApp>) =>
  (store.page.value?.panels ?? []).map(({ photo }) => store.album.value.get(String(photo))?.name);

const page = (more: Partial<PageDocument>) => ({ merges: [], order: [], ...more }) as any;
const panel = (photo: string | null, more = {}) => ({
  photo,
  crop: { x: 0, y: 0, width: 1, height: 1 },
  locked: false,
  edited: true,
  ...more,
});

test('another photo of a stack takes its place in the page, but not in a locked panel', () => {
  const before = page({ panels: [panel('a'), panel('b'), panel('a', { locked: true })], order: ['a', 'b', 'c'] });
  const after = exchanged(before, 'c', ['a', 'c']);
  expect(after.panels.map(({ photo }) => photo)).toEqual(['c', 'b', 'a']);
  expect(after.panels[0]).toMatchObject({ crop: null, edited: false });
  expect(after.panels[1]).toBe(before.panels[1]);
  expect(after.order).toEqual(['c', 'b']);
});

test('photos are put in order without those that are locked, and merged panels stay together', () => {
  const before = page({
    panels: [panel('c'), panel('b', { locked: true }), panel('a'), panel('a'), panel('d')],
    merges: [[2, 3]],
    order: ['c', 'b', 'a', 'd'],
  });
  const after = resorted(before, ['a', 'b', 'c', 'd']);
  expect(after.panels.map(({ photo }) => photo)).toEqual(['a', 'b', 'c', 'c', 'd']);
  expect(after.panels[4]).toBe(before.panels[4]);
  expect(after.order).toEqual(['a', 'b', 'c', 'd']);
});

test('to take another, to set how alike photos are and to order them are each one step', async () => {
  const app = fakeApp({ 'b.jpg': 'twin' });
  // Photos of different times keep their order.
  const { importPhoto } = app.engine;
  app.engine.importPhoto = async (id: string, file: File) => ({
    ...(await importPhoto(id, file)),
    taken: `2026:01:01 00:00:0${id.slice(1)}`,
  });
  const choosing = createChoosing({ ...app, enlarged });
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg'));
  expect(names(app)).toEqual(['a.jpg', 'c.jpg']);
  choosing.take('p2', ['p1', 'p2']);
  expect(names(app)).toEqual(['b.jpg', 'c.jpg']);
  app.pages.undo();
  expect(names(app)).toEqual(['a.jpg', 'c.jpg']);
  const asked = app.store.project.value.alike;
  choosing.setDuplicateThreshold(4);
  expect(app.store.project.value.alike).toBe(4);
  app.pages.undo();
  expect(app.store.project.value.alike).toBe(asked);
  choosing.setOrder('name');
  expect(app.store.project.value.order).toBe('name');
  const { length } = app.store.history.value.past;
  choosing.setOrder('name');
  expect(app.store.history.value.past.length).toBe(length);
});

test('a star that cannot enlarge its panel says why', async () => {
  const app = fakeApp();
  const larger = vi.fn(() => null as any);
  const choosing = createChoosing({ ...app, enlarged: larger });
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
  const notes = () => app.messages.list.value.map(({ text }) => text);
  choosing.star('p1', true);
  expect(notes()).toEqual([strings.starKeepsSize]);
  choosing.star('p1', false);
  app.pages.lock('layout', true);
  choosing.star('p1', true);
  expect(notes().at(-1)).toBe(strings.starLocked);
  expect(larger).toHaveBeenCalledTimes(1);
  app.pages.lock('layout', false);
  larger.mockReturnValue('grid-3');
  const { length } = notes();
  choosing.star('p2', true);
  expect(app.store.page.value?.layout).toBe('grid-3');
  expect(notes()).toHaveLength(length);
});

test('the order is that of time only where the person wants it', async () => {
  const app = fakeApp();
  const choosing = createChoosing({ ...app, enlarged });
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
  for (const [id, taken] of [
    ['p1', '2026:02:01 00:00:00'],
    ['p2', '2026:01:01 00:00:00'],
  ]) {
    const fact = app.store.album.value.get(id) as any;
    app.store.know({ ...fact, meta: { ...fact.meta, taken } });
  }
  expect(app.store.photos.value.map(({ id }) => id)).toEqual(['p2', 'p1']);
  choosing.setOrder('name');
  expect(app.store.photos.value.map(({ id }) => id)).toEqual(['p1', 'p2']);
  expect(names(app)).toEqual(['a.jpg', 'b.jpg']);
});
