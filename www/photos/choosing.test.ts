import { expect, test } from 'vitest';
import { createChoosing } from './choosing.ts';
import { fakeApp } from '../document/testing.ts';
import { strings } from '../strings/strings.ts';

const names = ({ store }: ReturnType<typeof fakeApp>) =>
  (store.page.value?.panels ?? []).map(({ photo }) => store.album.value.get(String(photo))?.name);

test('to take another, to set how alike photos are and to order them are each one step', async () => {
  const app = fakeApp({ 'b.jpg': 'twin' });
  // Photos of different times keep their order.
  const { importPhoto } = app.engine;
  app.engine.importPhoto = async (id: string, file: File) => ({
    ...(await importPhoto(id, file)),
    taken: `2026:01:01 00:00:0${id.slice(1)}`,
  });
  const choosing = createChoosing(app);
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
  const { undos } = app.store.mirror.value;
  choosing.setOrder('name');
  expect(app.store.mirror.value.undos).toBe(undos);
});

test('a star that cannot enlarge its panel says why', async () => {
  const app = fakeApp();
  const choosing = createChoosing(app);
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg'));
  const notes = () => app.messages.list.value.map(({ text }) => text);
  app.pages.chooseLayout('splash');
  const shown = app.store.page.value?.panels[0].photo as string;
  choosing.star(shown, true);
  expect(notes()).toEqual([strings.starKeepsSize]);
  app.pages.chooseLayout('grid-4');
  app.pages.lock('layout', true);
  const other = app.store.page.value?.panels.find(({ photo }) => photo !== shown)?.photo as string;
  choosing.star(other, true);
  expect(notes().at(-1)).toBe(strings.starLocked);
  app.pages.lock('layout', false);
  choosing.star(other, false);
  const { length } = notes();
  choosing.star(other, true);
  expect(app.store.page.value?.layout).toMatchObject({ family: 'custom' });
  expect(notes()).toHaveLength(length);
});

test('the order is that of time only where the person wants it', async () => {
  const app = fakeApp();
  const choosing = createChoosing(app);
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
