import { expect, test } from 'vitest';
import { shifted } from '../page/panels/cuts.tsx';
import { createMerging, grown } from '../page/panels/merging.ts';
import { createReshaping } from '../page/panels/reshaping.ts';
import { createSelection } from '../page/panels/selection.ts';
import { fakeApp } from './testing.ts';
import { strings } from '../strings/strings.ts';
import type { PageDocument } from '../engine/types.ts';

async function app(names = ['a', 'b', 'c', 'd']) {
  const made = fakeApp();
  await made.reading.addFiles(made.files(...names));
  const { store, pages } = made;
  const selection = createSelection({ store });
  const merging = createMerging({ store, pages, selection });
  const reshaping = createReshaping({ store, pages, seed: () => 7 });
  const page = () => store.page.value as PageDocument;
  return { ...made, selection, merging, reshaping, page };
}

test('a click chooses one panel, with a key or in the mode for it one more', async () => {
  const { selection } = await app();
  selection.press(2, false);
  selection.press(1, false);
  expect(selection.panels.value).toEqual([1]);
  selection.press(3, true);
  selection.choose(true);
  selection.press(0, false);
  selection.press(3, false);
  expect(selection.panels.value).toEqual([0, 1]);
  selection.choose(false);
  expect(selection.panels.value).toEqual([]);
});

test('a choice belongs to its page', async () => {
  const { selection, pages } = await app();
  selection.set([0, 1]);
  pages.shuffle('style');
  expect(selection.panels.value).toEqual([]);
});

test('panels are merged and split, each one step of the undo', async () => {
  const { selection, merging, pages, page } = await app();
  expect(merging.cannotMerge()).toBe(strings.merging.few);
  expect(merging.cannotSplit()).toBe(strings.merging.none);
  const photos = page().panels.map(({ photo }) => photo);
  selection.set([1, 0]);
  merging.merge();
  expect(page().merges).toEqual([[0, 1]]);
  expect(merging.cannotMerge()).toBe(strings.merging.already);
  expect(
    page()
      .panels.map(({ photo }) => photo)
      .slice(2),
  ).toEqual(photos.slice(2));
  // Without a selection, the only merged group is split.
  selection.clear();
  merging.split();
  expect(page().merges).toEqual([]);
  pages.undo();
  expect(page().merges).toEqual([[0, 1]]);
  pages.undo();
  expect(page().merges).toEqual([]);
});

test('a merge needs panels that touch', async () => {
  const { selection, merging, pages, page } = await app();
  pages.chooseLayout('grid-4');
  selection.set([0, 3]);
  expect(merging.cannotMerge()).toBe(strings.merging.apart);
  selection.set([0, 2, 3]);
  expect(merging.cannotMerge()).toBe('');
  selection.set([0, 1]);
  merging.merge();
  expect(grown([1, 3], page())).toEqual([0, 1, 3]);
});

test('a surprise has the wanted number of panels', async () => {
  const { reshaping, pages, page } = await app();
  pages.wantPanels(3);
  reshaping.surprise();
  expect(page().layout).toMatchObject({ family: 'generated' });
  expect(page().panels.length).toBe(3);
});

test('one drag of a cut is one step of the undo', async () => {
  const { reshaping, pages, store, page } = await app();
  const { layout } = page();
  const steps = store.mirror.value.undos;
  for (const fraction of [0.4, 0.5, 0.6]) reshaping.moveCut(0, { fraction, slant: 0 }, 'drag');
  expect(store.layoutFacts.value?.cuts[0].fraction).toBeCloseTo(0.6);
  expect(store.mirror.value.undos).toBe(steps + 1);
  pages.undo();
  expect(page().layout).toBe(layout);
});

test('panels are joined as one step of the undo, where one panel is to be made of them', async () => {
  const { reshaping, pages, store, page } = await app();
  pages.chooseLayout('grid-4');
  const { layout, panels } = page();
  const steps = store.mirror.value.undos;
  expect(reshaping.cannotJoin([0])).toBe(strings.merging.few);
  expect(reshaping.cannotJoin([0, 3])).toBe(strings.merging.uneven);
  reshaping.joinPanels([0, 3]);
  expect(page().layout).toBe(layout);
  expect(reshaping.cannotJoin([0, 2])).toBe('');
  reshaping.joinPanels([0, 2]);
  expect(page().panels.length).toBe(panels.length - 1);
  expect(page().layout).toMatchObject({ family: 'custom' });
  expect(store.mirror.value.undos).toBe(steps + 1);
  pages.undo();
  expect(page().layout).toBe(layout);
});

test('an end of a cut moves, the other stays', () => {
  const cut = { fraction: 0.5, slant: 0.1 } as any;
  expect(shifted(cut, 'both', 0.1)).toEqual({ fraction: 0.6, slant: 0.1 });
  for (const [end, fixed] of [
    ['from', 1],
    ['to', -1],
  ] as const) {
    const { fraction, slant } = shifted(cut, end, 0.2);
    expect(fraction + (fixed * slant) / 2).toBeCloseTo(0.5 + fixed * 0.05);
  }
});
