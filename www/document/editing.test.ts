import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { bytesOf } from '../engine/interned.ts';
import { createEditing, openEditing } from './editing.ts';
import { EMPTY_MIRROR } from './history.ts';
import { DEFAULT_SETTINGS } from './empty.ts';
import { edited, historyOf, pageOf } from './testing.ts';
import { core } from '../engine/testing-core.ts';
import type { Editing } from './editing.ts';
import type { Change } from './history.ts';
import type { Intent } from '../engine/types.ts';
import type { Action } from './project.ts';

const show = (id: number): Change => ({ type: 'show-page', page: pageOf(id), pageId: id });

describe('what is read beside the core', () => {
  test('keeps the very objects that an edit leaves as they were', () => {
    const editing = edited({ type: 'add-photos', ids: ['a', 'b'] }, show(1), show(2));
    const before = editing.mirror();
    const after = editing.apply({ type: 'star-photo', id: 'a', on: true });
    expect([before.undos, after.undos, after.redos, after.step === before.step]).toEqual([3, 4, 0, false]);
    for (const part of ['page', 'settings', 'others', 'locks', 'mine'] as const)
      expect(after.present[part]).toBe(before.present[part]);
    expect(after.shown).toBe(before.shown);
    expect(after.present.tray[1]).toBe(before.present.tray[1]);
    expect(after.present.tray[0]).toEqual({ id: 'a', use: null, starred: true });
  });

  test('goes back and forth with the very pages', () => {
    const editing = edited({ type: 'add-photos', ids: ['a'] }, show(1), show(2));
    const { present, shown } = editing.mirror();
    const back = editing.apply({ type: 'undo' });
    expect([back.undos, back.redos, back.present.pageId]).toEqual([2, 1, 1]);
    expect([back.present.page === shown[0].page, back.present.tray === present.tray]).toEqual([true, true]);
    const forth = editing.apply({ type: 'redo' });
    expect(forth.present).toEqual(present);
    expect(forth.present.page).toBe(present.page);
    expect(editing.apply({ type: 'redo' })).toBe(editing.mirror());
  });

  test('counts a step for each undo step, not for a part of a coalesced edit', () => {
    const editing = edited({ type: 'rename', name: 'One', gesture: 'g' });
    const { step } = editing.mirror();
    const steps = [
      { type: 'rename', name: 'Two', gesture: 'g' },
      { type: 'rename', name: 'Three', silent: true },
      { type: 'rename', name: 'Four' },
      { type: 'undo' },
    ].map((change) => editing.apply(change as Change).step);
    expect(steps.slice(0, 2)).toEqual([step, step]);
    expect(new Set(steps).size).toBe(3);
  });

  test('has a page as the very one that was given', () => {
    const pages = [pageOf(1), pageOf(2)];
    const editing = edited({ type: 'show-page', page: pages[0], pageId: 1 });
    expect(editing.mirror().present.page).toBe(pages[0]);
    expect(editing.mirror().shown[0].page).toBe(pages[0]);
    const sheets = pages.map((page, i) => ({ page, pageId: i + 1, sheet: i }));
    const { present, shown } = editing.apply({ type: 'set-sheets', sheets, at: 1 });
    expect([present.page, present.others[0].page, shown[1].page].map((page) => pages.indexOf(page as any))).toEqual([
      1, 0, 1,
    ]);
  });

  test('knows pages by their ids alone where the core has them', () => {
    const told: string[] = [];
    const editor = core.createEditor();
    const editing = createEditing({ ...editor, apply: (edit) => (told.push(edit), editor.apply(edit)) });
    const [one, two] = [pageOf(1), pageOf(2)];
    editing.apply({ type: 'show-page', page: one, pageId: 1 });
    editing.apply({ type: 'show-page', page: two, pageId: 2 });
    editing.apply({ type: 'show-page', page: one, pageId: 1 });
    expect([told[2], editing.mirror().present.page === one]).toEqual(['{"type":"show-page","pageId":1}', true]);
    // A different page with that id is sent in full.
    editing.apply({ type: 'show-page', page: { ...two, seed: 9 }, pageId: 2 });
    expect(editing.mirror().present.page?.seed).toBe(9);
  });

  test('is as it was where the core refuses an edit', () => {
    const editing = edited(show(1));
    const before = editing.mirror();
    const wrong = { ...pageOf(2), layout: 'no such layout' };
    expect(() => editing.apply({ type: 'change-page', page: wrong })).toThrow(/layout/);
    expect(editing.mirror()).toBe(before);
    expect(editing.apply({ type: 'undo' }).present.page).toBe(null);
  });

  test('is as the core reads it where something of it is left out', () => {
    const history = historyOf(edited(show(1), show(2)));
    const broken = { ...history.past[1], page: { ...pageOf(1), layout: 'no such layout' } };
    const bytes = bytesOf({ version: 1, history: { ...history, past: [history.past[0], broken] } });
    const editing = openEditing(core.createEditor(), bytes);
    expect([editing.mirror().undos, editing.dropped]).toEqual([1, [expect.stringMatching(/layout/)]]);
    expect(editing.apply({ type: 'undo' }).present).toEqual(history.past[0]);
  });

  test('has the photos of all times', () => {
    const editing = edited({ type: 'add-photos', ids: ['a', 'b'] }, { type: 'remove-photos', ids: ['a'] });
    const panels = pageOf(1).panels.map((panel, i) => ({ ...panel, photo: ['b', 'c', null, null][i] }));
    editing.apply({ type: 'add-photos', ids: ['c', 'd'] });
    editing.apply({ type: 'show-page', page: { ...pageOf(1), panels }, pageId: 1 });
    editing.apply({ type: 'undo' });
    editing.apply({ type: 'undo' });
    expect(editing.photos().sort()).toEqual(['a', 'b', 'c', 'd']);
    editing.apply({ type: 'forget-photos', ids: ['c'] });
    expect(editing.photos().sort()).toEqual(['a', 'b', 'd']);
  });

  test('takes halves of letters for signs, and a name has an end', () => {
    const { present } = edited({ type: 'rename', name: `a\ud800b\\ud800${'x'.repeat(2_000)}` }).mirror();
    expect([present.name.slice(0, 9), present.name.length]).toEqual(['a\ufffdb\\ud800', 1_000]);
  });
});

const LAYOUT = core.layoutFile('grid-2');
const photo = fc.constantFrom('a', 'b', 'c');
const anId = fc.integer({ min: 1, max: 9 });
const items = fc
  .subarray(['x', 'y', 'z'])
  .map((ids) => ids.map((id) => ({ id, name: id, tags: [], background: [] })) as any[]);
const gesture = fc.constantFrom(undefined, 'drag', 'drag', 'other');
/** One arbitrary per kind of edit except intents: a missing kind does not compile. */
const actions: Record<Exclude<Action['type'], Intent['type']>, fc.Arbitrary<any>> = {
  'add-photos': fc.record({ ids: fc.subarray(['a', 'b', 'c']) }),
  'remove-photos': fc.record({ ids: fc.subarray(['a', 'b', 'c']) }),
  // `forget-photos` is not a step and has separate tests.
  'forget-photos': fc.record({ ids: fc.constant([]) }),
  'use-photos': fc.record({ uses: fc.dictionary(photo, fc.boolean()) }),
  'exchange-photo': fc.record({ id: photo, by: fc.constantFrom('d', 'e') }),
  'choose-by': fc.record({ alike: fc.integer({ min: 4, max: 16 }), order: fc.constantFrom('time', 'name') }),
  'focus-photo': fc.record({ id: photo, focus: fc.constantFrom(null, { x: 0.2, y: 0.7 }) }),
  'star-photo': fc.record({ id: photo, on: fc.boolean() }),
  'mask-photo': fc.record({ id: photo, mask: fc.constantFrom(null, '2x1:ap', '2x1:p2') }),
  lock: fc.record({ part: fc.constantFrom('layout', 'style', 'photos'), on: fc.boolean() }),
  'want-panels': fc.record({ count: fc.constantFrom(null, 1, 4) }),
  'show-page': anId.map((id) => ({ page: pageOf(id), pageId: id })),
  'change-page': anId.map((id) => ({ page: pageOf(id) })),
  'change-settings': anId.map((id) => ({ page: pageOf(id), settings: { ...DEFAULT_SETTINGS, gutter: id / 100 } })),
  'set-sheets': fc.tuple(fc.uniqueArray(anId, { minLength: 1, maxLength: 4 }), fc.nat({ max: 3 })).map(([ids, at]) => ({
    sheets: ids.map((id) => ({ page: pageOf(id), pageId: id + 10, sheet: id })),
    at: at % ids.length,
  })),
  'add-words': fc.tuple(photo, fc.constantFrom(undefined, 1, 2)).map(([id, sheet]) => ({
    words: [{ kind: 'balloon', text: id, photo: sheet ? null : id, panel: 0, sheet, auto: true }],
  })),
  'set-words': photo.map((text) => ({ pages: [{ at: 0, words: [{ kind: 'caption', text }] }] })),
  'drop-waiting': fc.record({ words: fc.subarray([0, 1]) }),
  'no-page': fc.constant({}),
  design: fc.constantFrom(
    { draft: null },
    { draft: { id: 'd', name: 'D', tags: [], background: [], foreground: [], ink: '#000000' } },
  ),
  'own-styles': items.map((mine) => ({ mine })),
  favourites: items.map((favourites) => ({ favourites })),
  'own-layouts': fc.subarray(['x', 'y', 'z']).map((ids) => ({ ownLayouts: ids.map((id) => ({ ...LAYOUT, id })) })),
  'love-page': fc.record({ pageId: anId, on: fc.boolean() }),
  'describe-shots': fc.record({
    shots: fc.dictionary(
      fc.constantFrom('a', 'b', 'c'),
      fc.record({ scene: fc.constantFrom('1', '2'), frames: fc.nat(99).map((frames) => frames + 1) }),
    ),
  }),
  'set-board': fc.record({
    board: fc.record({
      fps: fc.constantFrom(24, 25),
      columns: fc.subarray(['Lens', 'Sound']),
      order: fc.subarray(['b', 'a']),
      logo: fc.constantFrom('', 'data:image/png;base64,iVBORw0KGgo='),
    }),
  }),
  rename: fc.record({ name: fc.constantFrom('', 'One', 'Two') }),
  styling: fc.record({
    styling: fc.record({ invented: fc.constantFrom(0, 0.5), keepLines: fc.boolean(), keepColours: fc.boolean() }),
  }),
};
const action = fc.oneof(
  ...Object.entries(actions).map(([type, rest]) =>
    fc.tuple(rest, gesture).map(([parts, of]) => ({ type, ...parts, ...(of ? { gesture: of } : {}) }) as Change),
  ),
);
const step = fc.constantFrom('undo', 'redo').map((type) => ({ type }) as Change);
const changes = fc.array(fc.oneof({ weight: 4, arbitrary: action }, { weight: 1, arbitrary: step }), { maxLength: 60 });

function isSame(editing: Editing) {
  const { past, present, future, shown } = historyOf(editing);
  const { undos, redos, ...told } = editing.mirror();
  expect(JSON.parse(JSON.stringify({ present: told.present, shown: told.shown }))).toEqual({ present, shown });
  expect([undos, redos]).toEqual([past.length, future.length]);
}

describe('whatever is done', () => {
  test('what is read here is what the core has', () => {
    fc.assert(
      fc.property(changes, (list) => {
        const editing = createEditing(core.createEditor());
        for (const one of list) {
          editing.apply(one);
          isSame(editing);
        }
        const again = openEditing(core.createEditor(), editing.save().bytes);
        expect(again.mirror()).toEqual({ ...editing.mirror(), step: again.mirror().step });
        again.apply({ type: 'forget-photos', ids: ['a', 'd'] });
        editing.apply({ type: 'forget-photos', ids: ['a', 'd'] });
        isSame(editing);
        expect(historyOf(again)).toEqual(historyOf(editing));
        expect(again.fresh()).toEqual(editing.fresh());
      }),
    );
  });

  test('undoing everything leads to the start, and redoing everything back', () => {
    fc.assert(
      fc.property(changes, (list) => {
        const editing = edited(...list);
        const end = editing.mirror();
        while (editing.mirror().undos > 0) editing.apply({ type: 'undo' });
        expect(editing.mirror().present).toEqual(EMPTY_MIRROR.present);
        while (editing.mirror().redos > end.redos) editing.apply({ type: 'redo' });
        expect(editing.mirror().present).toEqual(end.present);
        if (end.present.page)
          expect(editing.mirror().shown).toContainEqual(
            expect.objectContaining({ id: end.present.pageId, page: end.present.page }),
          );
      }),
    );
  });

  test('nothing is changed in place', () => {
    fc.assert(
      fc.property(changes, changes, (first, second) => {
        const editing = edited(...first);
        const before = editing.mirror();
        const copy = structuredClone(before);
        second.forEach((change) => editing.apply(change));
        expect(before).toEqual(copy);
      }),
    );
  });

  test('an editor that broke goes on in another one', () => {
    fc.assert(
      fc.property(changes, changes, (first, second) => {
        const editing = edited(...first);
        editing.save();
        second.forEach((change) => editing.apply(change));
        const before = historyOf(edited(...first, ...second));
        editing.revive(core.createEditor());
        isSame(editing);
        expect(historyOf(editing)).toEqual(before);
      }),
    );
  });
});
