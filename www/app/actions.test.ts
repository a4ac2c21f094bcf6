import { signal } from '@preact/signals';
import { describe, expect, it, test, vi } from 'vitest';
import { keyLines } from '../help/key-lines.ts';
import { inLanguage, translations } from '../strings/testing.ts';
import { everyAction, isEnabled, now } from '../ui/action.ts';
import { toolsFor } from '../page/context-bar.tsx';
import { Icon } from '../ui/icon.tsx';
import { keyNames } from '../ui/shortcut.ts';
import { createActions } from './app.ts';
import { fakeParts } from './app-testing.ts';
import type { Action } from '../ui/action.ts';
import type { App } from '../ui/context.ts';

/** Entries that must not change. New entries may be added. */
const HELP = [
  ['Space', 'Shuffle'],
  ['L', 'Shuffle layout'],
  ['S', 'Shuffle style'],
  ['P', 'Shuffle photos'],
  ['Ctrl Z', 'Undo'],
  ['Shift Ctrl Z', 'Redo'],
  ['← ↑ → ↓', 'Move between panels'],
  ['Page Up Page Down', 'Move between pages'],
  ['Enter', 'Move a panel’s photo with the arrows'],
  [', .', 'Earlier or later frame of a video; with Shift, by one second'],
  ['+ − 0', 'Zoom a panel’s photo, reset it'],
  ['Shift Enter', 'Select a panel'],
  ['Alt ↑ ↓', 'Slant a divider of the layout'],
  ['Ctrl S', 'Download PNG'],
  ['?', 'This list'],
];

const all = async () => everyAction({ ...createActions(await fakeParts()) });

describe.each(Object.keys(translations))('in %s', (language) => {
  it('every action has a label', async () => {
    vi.resetModules();
    vi.doMock('../strings/strings.ts', () => ({ language, strings: inLanguage(language) }));
    const fresh = await import('./app.ts');
    const actions = everyAction({ ...fresh.createActions(await fakeParts()) });
    vi.doUnmock('../strings/strings.ts');
    const label = ({ label }: Action) => now(label as Action['label']);
    expect(actions.length).toBeGreaterThan(50);
    expect(new Map(actions).get('page.undo')?.label).toBe(inLanguage(language).undo);
    expect(actions.filter(([, action]) => !label(action)).map(([id]) => id)).toEqual([]);
  });
});

test('every icon is drawn', async () => {
  const missing = (await all()).filter(([, { icon }]) => {
    const name = now(icon);
    return name !== undefined && !(Icon({ name }).props.children as any).props.d;
  });
  expect(missing.map(([id]) => id)).toEqual([]);
});

test('no two actions have a shortcut in common where both are heard', async () => {
  const shortcuts = (await all()).flatMap(([id, { keys = [], heard }]) =>
    keys.map((keys) => ({ id, place: `${heard === 'panel' ? 'panel' : 'window'} ${keys}` })),
  );
  const twice = shortcuts.filter(({ place }, i) => shortcuts.findIndex((other) => other.place === place) !== i);
  expect(shortcuts.length).toBeGreaterThan(15);
  expect(twice).toEqual([]);
});

test('every action with keys is in the list of keys', async () => {
  const actions = createActions(await fakeParts());
  const lines = keyLines({ ...actions });
  const untold = everyAction({ ...actions }).filter(([, { keys, about, label }]) => {
    const line = lines.find(({ does }) => does === (about ?? now(label)));
    return keys && !keyNames(keys[0]).every((key) => line?.keys.includes(key));
  });
  expect(untold.map(([id]) => id)).toEqual([]);
});

test('the list of keys has the keys that people know, in their order', async () => {
  const lines = keyLines({ ...createActions(await fakeParts()) }).map(({ keys, does }) => [keys.join(' '), does]);
  const known = new Set(HELP.map(String));
  expect(lines.filter((line) => known.has(String(line)))).toEqual(HELP);
});

test.each(['panels.join', 'panels.merge', 'panels.split', 'panels.swap'])(
  '%s ends the selection of panels',
  async (id) => {
    const parts = await fakeParts();
    parts.pages.chooseLayout('grid-4');
    parts.selection.choose(true);
    for (const panel of [0, 1]) parts.selection.press(panel, false);
    if (id === 'panels.split') parts.merging.merge();
    new Map(everyAction({ ...createActions(parts) })).get(id)?.run();
    parts.selection.press(2, false);
    expect(parts.selection.panels.value).toEqual([2]);
  },
);

test('a page of a book has a few tools, also with one version', async () => {
  const parts = await fakeParts();
  const bookMaking = { progress: signal(null) };
  const app = { ...parts, bookMaking } as unknown as App;
  const tools = () => toolsFor({ ...app, actions: createActions(app) })?.shown;
  parts.book.add();
  expect([parts.store.versions.value.length, tools()]).toEqual([1, 2]);
});

/** Actions that need a browser, a video, fonts, models or the real core. */
const ELSEWHERE =
  /^(page\.acceptCrops|book\.(cancel|make|cover)|photos\.(add|choose|trySamples)|layouts\.(save|forget)|projects\.(create|save|cancel|openCopy|goBack)|window\.install|panels\.(save|breakFrame|earlier|later|zoom|fit|rotate|flip|reset|cut|slant|inset)|words|text|designer|explorer|imitation\.edit|styles|download\.download)/;
/** They are the undo itself. */
const WALKS = ['page.undo', 'page.redo'];

const HERE = (await all()).map(([id]) => id).filter((id) => !ELSEWHERE.test(id) && !WALKS.includes(id));

test('most actions can be done here', () => expect(HERE.length).toBeGreaterThan(30));

test.each(HERE)('%s counts in the undo as its mark says', async (id) => {
  const parts = await fakeParts();
  const { store, pages, book, selection, merging } = parts;
  // Two pages, the current one with earlier and later versions, and panels that can be merged or split.
  book.add();
  if (id !== 'book.earlier') book.go(0);
  pages.shuffle('all');
  pages.chooseStyle('noir');
  pages.previous();
  if (id === 'panels.join') pages.chooseLayout('grid-4');
  selection.set([0, 1]);
  if (id === 'panels.split') merging.merge();
  else if (!['panels.merge', 'panels.join', 'panels.swap'].includes(id)) selection.set([0]);
  if (id === 'window.shrinkPage') parts.ui.zoom.value = 2;
  if (id === 'download.hideMarks') parts.ui.printCheck.value = 8;
  parts.imitation.proposals.value = [{ id: 'like-1', name: 'Like a print', tags: [], background: [] }];
  parts.imitation.shown.value = 'like-1';
  if (id === 'boards.followPages') parts.boards.move(0, 1);
  if (id === 'imitation.stop') parts.imitation.progress.value = 0.5;
  const action = new Map(everyAction({ ...createActions(parts) })).get(id);
  const before = store.mirror.peek().undos;
  if (action && isEnabled(action)) action.run();
  else expect.fail('it cannot be done here');
  expect(store.mirror.peek().undos - before).toBe(action.undo === undefined ? 0 : 1);
});
