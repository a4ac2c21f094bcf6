import { expect, test } from 'vitest';
import { core } from '../engine/testing-core.ts';
import { createEditing } from './editing.ts';
import { EMPTY_PROJECT } from './empty.ts';
import { createStore } from './store.ts';
import { pageOf } from './testing.ts';
import type { Change } from './history.ts';

const show: Change = { type: 'show-page', page: pageOf(1), pageId: 1 };

test('what is done before the core is there is done when it is', () => {
  const store = createStore();
  store.change({ type: 'rename', name: 'Early' });
  expect(store.project.value.name).toBe('');
  store.planner.value = core;
  expect([store.project.value.name, store.mirror.value.undos]).toEqual(['Early', 1]);
});

test('what the core refuses is told, and all is as it was', () => {
  const told: string[] = [];
  const store = createStore({ onRefused: ({ message }) => told.push(message) });
  store.planner.value = core;
  store.change(show);
  const before = store.mirror.value;
  const page = { ...pageOf(2), style: 'no such style' };
  expect(() => store.change({ type: 'change-page', page })).toThrow(/style/);
  expect([told.length, store.mirror.value === before]).toEqual([1, true]);
  store.change({ type: 'undo' });
  expect(store.page.value).toBe(null);
});

test('an editor that broke is replaced by one of the same history', () => {
  const store = createStore();
  let broken = 0;
  const createEditor = () => {
    const editor = core.createEditor();
    let isBroken = false;
    const apply = (edit: string) => {
      if (edit.includes('Trap') && broken === 0) {
        broken += 1;
        isBroken = true;
      }
      if (isBroken) throw new WebAssembly.RuntimeError('unreachable');
      return editor.apply(edit);
    };
    return { ...editor, apply };
  };
  store.planner.value = { ...core, createEditor };
  store.change(show);
  expect(() => store.change({ type: 'rename', name: 'Trap' })).toThrow('unreachable');
  store.change({ type: 'rename', name: 'Trap' });
  store.change({ type: 'undo' });
  expect([store.page.value?.seed, store.mirror.value.undos, store.fresh().pageId]).toEqual([1, 1, 2]);
});

test('another document takes its place with its editor, and gives it back', () => {
  const store = createStore();
  store.planner.value = core;
  store.change(show);
  const [mirror, editing] = [store.mirror.value, store.editing()];
  const other = { album: new Map(), videos: new Map() };
  store.load({ ...other, editing: createEditing(core.createEditor(), mirror) });
  expect([store.mirror.value.undos, store.step.value === mirror.step]).toEqual([0, false]);
  store.change({ type: 'rename', name: 'Other' });
  store.load({ ...other, editing });
  expect([store.mirror.value === mirror, store.editing() === editing]).toEqual([true, true]);
  store.change({ type: 'undo' });
  expect([store.page.value, store.project.value.name]).toEqual([null, '']);
  store.load({ ...other, editing: null });
  store.change({ type: 'rename', name: 'New' });
  expect([store.mirror.value.undos, store.mirror.value.shown]).toEqual([1, []]);
});

test('an invalid document has no editor', () => {
  const page = { ...pageOf(2), layout: 'no such layout' };
  const present = { ...EMPTY_PROJECT, page };
  expect(() => createEditing(core.createEditor(), { present, shown: [] })).toThrow(/layout/);
});
