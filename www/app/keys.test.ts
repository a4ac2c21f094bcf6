import { signal } from '@preact/signals';
import { beforeEach, expect, test, vi } from 'vitest';
import { createKeys } from './keys.ts';

class FakeElement {
  isContentEditable = false;
  constructor(private readonly matched: string) {}
  matches(selector: string) {
    return selector.split(', ').some((part) => part.startsWith(this.matched));
  }
  closest(selector: string) {
    return selector.split(', ').includes(this.matched) ? this : null;
  }
}

const runs = { shuffle: vi.fn(), layout: vi.fn(), undo: vi.fn(), redo: vi.fn(), save: vi.fn(), zoom: vi.fn() };
const enabled = signal(true);
let isCovered = false;
const ui = { work: signal(null), dialog: signal(null), letterKeys: signal(true) } as any;
const leave = vi.fn();
const listen = createKeys({
  ui,
  leave: () => leave,
  covered: () => isCovered,
  actions: {
    page: {
      shuffle: { label: 'Shuffle', keys: ['Space'], enabled, run: runs.shuffle },
      layout: { label: 'Layout', keys: ['L'], run: runs.layout },
      undo: { label: 'Undo', keys: ['Mod+Z'], heard: 'everywhere', run: runs.undo },
      redo: { label: 'Redo', keys: ['Shift+Mod+Z', 'Mod+Y'], heard: 'everywhere', run: runs.redo },
      save: { label: 'Save', keys: ['Mod+S'], enabled, run: runs.save },
      zoom: { label: 'Zoom', keys: ['+'], heard: 'panel', run: runs.zoom },
    },
  },
});

/** @returns whether the default action of the browser is prevented */
function press(key: string, how: Partial<KeyboardEvent> = {}) {
  const preventDefault = vi.fn();
  listen({
    key,
    target: null,
    altKey: false,
    ctrlKey: false,
    metaKey: false,
    shiftKey: false,
    ...how,
    preventDefault,
  } as any);
  return preventDefault.mock.calls.length > 0;
}
const ran = () =>
  Object.entries(runs)
    .filter(([, { mock }]) => mock.calls.length > 0)
    .map(([name]) => name);

beforeEach(() => {
  vi.clearAllMocks();
  vi.stubGlobal('HTMLElement', FakeElement);
  vi.stubGlobal('Element', FakeElement);
  enabled.value = true;
  isCovered = false;
  ui.work.value = null;
  ui.dialog.value = null;
  ui.letterKeys.value = true;
});

test('a key does what its action does, as Ctrl and Cmd do', () => {
  expect([press(' '), press('l'), press('z', { metaKey: true })]).toEqual([true, true, true]);
  expect(ran()).toEqual(['shuffle', 'layout', 'undo']);
});

test('Shift chooses between two, and may else be what a character needs', () => {
  press('Z', { ctrlKey: true, shiftKey: true });
  press('L', { shiftKey: true });
  expect(ran()).toEqual(['layout', 'redo']);
});

test('an action that is disabled does not run by its key', () => {
  enabled.value = false;
  // The browser does not save a copy of the page, but may scroll.
  expect([press(' '), press('s', { ctrlKey: true })]).toEqual([false, true]);
  expect(ran()).toEqual([]);
});

test('keys are left to fields, to what has the focus, to dialogs and to Alt', () => {
  const on = (matched: string) => ({ target: new FakeElement(matched) as any });
  press('l', on('input'));
  press('z', { ...on('textarea'), ctrlKey: true });
  press(' ', on('button'));
  press('l', { altKey: true });
  press('+');
  isCovered = true;
  press('l');
  expect(ran()).toEqual([]);
});

test('over the board only what is for everywhere is heard, and Escape', () => {
  ui.work.value = 'designer';
  press(' ');
  press('s', { ctrlKey: true });
  press('z', { ctrlKey: true });
  press('Escape');
  expect([ran(), leave.mock.calls.length]).toEqual([['undo'], 1]);
});

test('while a dialog is loaded, no key acts, except that Escape cancels it', () => {
  ui.dialog.value = 'help';
  press('l');
  press('z', { ctrlKey: true });
  expect([ran(), ui.dialog.value]).toEqual([[], 'help']);
  press('Escape');
  expect([ran(), ui.dialog.value, leave.mock.calls.length]).toEqual([[], null, 0]);
});

test('single letters can be switched off, what needs none stays', () => {
  ui.letterKeys.value = false;
  press('l');
  press(' ');
  expect(ran()).toEqual(['shuffle']);
});
