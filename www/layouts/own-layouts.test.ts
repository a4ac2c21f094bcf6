import { expect, test, vi } from 'vitest';
import { createShelves } from '../storage/shelves.ts';
import { createOwnLayouts } from './own-layouts.ts';
import { lengthIn, pixelsOf, whyNotSize } from '../page/paper.ts';
import { core } from '../engine/testing-core.ts';
import { fakeApp } from '../document/testing.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

function app(kept = null as string | null) {
  const made = fakeApp();
  const { store, pages, messages } = made;
  let text = kept;
  const box = {
    getItem: () => text,
    setItem: (_: string, value: string) => {
      text = value;
    },
  };
  const layouts = createOwnLayouts({ store, pages, messages });
  const shelves = createShelves({ store, messages, box: () => box });
  return { ...made, layouts, shelves, kept: () => JSON.parse(text ?? '[]') };
}

const layout = (id: string) => ({ ...core.layoutFile('grid-2'), id, name: 'Mine' });
const file = (name: string, layout: any) =>
  new File([typeof layout === 'string' ? layout : JSON.stringify(layout)], name);

test('a layout is opened from a file, shown, kept and forgotten', async () => {
  const { layouts, shelves, store, reading, files, kept, pages } = app();
  shelves.recall();
  await reading.addFiles(files('a', 'b'));
  await layouts.open([file('mine.json', layout('x2'))]);
  expect(store.page.value?.layout).toEqual(layout('x2'));
  expect(kept()).toEqual([layout('x2')]);
  expect(layouts.isOwn('x2')).toBe(true);
  layouts.remove('x2');
  expect([kept(), store.own.value]).toEqual([[], []]);
  pages.undo();
  expect([kept().length, layouts.isOwn('x2')]).toEqual([1, true]);
});

test('a bad file is named with the reason, and the good ones count', async () => {
  const { layouts, store, messages } = app();
  await layouts.open([file('bad.json', {}), file('good.json', layout('y1')), file('long.json', ' '.repeat(300_000))]);
  await vi.waitFor(() => expect(messages.list.value.map(({ text }) => text)).toContain('2 files could not be read.'));
  const alerts = messages.failures.value.map(({ text }) => text);
  expect(alerts[0]).toMatch(/bad\.json.*id.*missing/);
  expect(alerts[1]).toMatch(/long\.json.*256 KB/);
  expect(store.own.value).toEqual([layout('y1')]);
});

test('what was kept is there again; what can no longer be read is not', () => {
  const { shelves, store } = app(JSON.stringify([layout('z1'), { broken: true }]));
  shelves.recall();
  expect(store.own.value).toEqual([layout('z1')]);
  const other = app('no json');
  other.shelves.recall();
  expect(other.store.own.value).toEqual([]);
});

test('one of the catalogue is saved as a file and not kept twice', async () => {
  const { layouts, store, pages, reading, files } = app();
  await reading.addFiles(files('a', 'b'));
  pages.chooseLayout('grid-2');
  layouts.save();
  expect(store.own.value).toEqual([]);
});

test('lengths go to pixels and back', () => {
  expect([pixelsOf(210, 'mm', 300), pixelsOf(297, 'mm', 300)]).toEqual([2480, 3508]);
  expect([lengthIn(2480, 'mm', 300), lengthIn(2550, 'in', 300), lengthIn(77, 'px', 300)]).toEqual([210, 8.5, 77]);
  expect(whyNotSize({ width: 2480, height: 3508, dpi: 300 })).toBe('');
  expect(whyNotSize({ width: 10, height: 3508, dpi: 300 })).toBe('side');
  expect(whyNotSize({ width: 14_000, height: 14_000, dpi: 300 })).toBe('pixels');
  expect(whyNotSize({ width: 2480, height: 3508, dpi: NaN })).toBe('dpi');
});
