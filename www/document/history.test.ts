import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { EMPTY_HISTORY, advance, freshPageId, position } from './history.ts';
import { DEFAULT_SETTINGS } from './project.ts';
import type { Change, History } from './history.ts';
import type { Action } from './project.ts';

const page = (seed: number): any => ({
  version: 1,
  seed,
  layout: 'a',
  style: 'b',
  order: [],
  panels: [],
  merges: [],
  page: DEFAULT_SETTINGS,
  words: [],
});
const play = (history: History, ...changes: Change[]) => changes.reduce(advance, history);
const show = (id: number): Change => ({ type: 'show-page', page: page(id), pageId: id });

describe('undo and redo', () => {
  test('walk through the steps, and a new step drops what was undone', () => {
    let history = play(EMPTY_HISTORY, show(1), show(2), { type: 'undo' });
    expect(history.present.page?.seed).toBe(1);
    history = advance(history, { type: 'redo' });
    expect(history.present.page?.seed).toBe(2);
    history = play(history, { type: 'undo' }, show(3));
    expect(advance(history, { type: 'redo' })).toBe(history);
  });

  test('one drag of a slider is one step', () => {
    const drag = (gutter: number) =>
      ({
        type: 'change-settings',
        settings: { ...DEFAULT_SETTINGS, gutter },
        page: page(1),
        gesture: 'gutter',
      }) as Change;
    const history = play(EMPTY_HISTORY, show(1), drag(0.02), drag(0.03), drag(0.04));
    expect(history.past.length).toBe(2);
    expect(advance(history, { type: 'undo' }).present.settings.gutter).toBe(DEFAULT_SETTINGS.gutter);
  });

  test('a page that is still growing makes no steps', () => {
    const history = play(EMPTY_HISTORY, show(1), { type: 'change-page', page: page(7), silent: true });
    expect(history.past.length).toBe(1);
    expect(history.shown).toEqual([{ id: 1, page: page(7) }]);
  });

  test('a photo that could not be read comes back by no undo', () => {
    const history = play(
      EMPTY_HISTORY,
      { type: 'add-photos', ids: ['a', 'b'] },
      show(1),
      { type: 'forget-photos', ids: ['a'] },
      { type: 'undo' },
    );
    expect(history.present.tray.map(({ id }) => id)).toEqual(['b']);
  });

  test('adding nothing but such photos leaves no step', () => {
    const history = play(EMPTY_HISTORY, show(1), { type: 'add-photos', ids: ['a', 'b'] });
    expect(history.past.length).toBe(2);
    expect(play(history, { type: 'forget-photos', ids: ['a'] }).past.length).toBe(2);
    expect(play(history, { type: 'forget-photos', ids: ['a', 'b'] }).past.length).toBe(1);
  });
});

describe('the pages shown', () => {
  test('keep every page, in the order shown, with its last edit', () => {
    const edited = { ...page(1), seed: 99 };
    const history = play(
      EMPTY_HISTORY,
      show(1),
      { type: 'change-page', page: edited },
      show(2),
      { type: 'undo' },
      show(3),
    );
    expect(history.shown.map(({ id }) => id)).toEqual([1, 2, 3]);
    expect(history.shown[0].page.seed).toBe(99);
    expect(position(history)).toBe(2);
  });

  test('know what each was made from, so that going back and shuffling branches', () => {
    const history = play(EMPTY_HISTORY, show(1), show(2), show(1), show(3));
    expect(history.shown.map(({ id, from }) => [id, from])).toEqual([
      [1, undefined],
      [2, 1],
      [3, 1],
    ]);
  });

  test('favourites stay when the oldest go', () => {
    const loved = play(EMPTY_HISTORY, show(1), show(2), { type: 'love-page', pageId: 1, on: true });
    const long = play(loved, ...Array.from({ length: 1100 }, (_, i) => show(i + 3)));
    expect(long.shown.length).toBe(1000);
    expect(long.shown.map(({ id }) => id).slice(0, 2)).toEqual([1, 104]);
  });

  test('going back to a page is a step, and leaves the list as it is', () => {
    const history = play(EMPTY_HISTORY, show(1), show(2), show(1));
    expect(history.shown.length).toBe(2);
    expect(position(history)).toBe(0);
    expect(position(advance(history, { type: 'undo' }))).toBe(1);
  });
});

const photo = fc.constantFrom('a', 'b', 'c');
const anId = fc.integer({ min: 1, max: 9 });
const items = fc.subarray(['x', 'y', 'z']).map((ids) => ids.map((id) => ({ id, name: id, tags: [] })) as any[]);
const gesture = fc.constantFrom(undefined, 'drag', 'drag', 'other');
/** One arbitrary a kind of action: a kind that is missing here does not compile. */
const actions: Record<Action['type'], fc.Arbitrary<any>> = {
  'add-photos': fc.record({ ids: fc.subarray(['a', 'b', 'c']) }),
  'remove-photo': fc.record({ id: photo }),
  'remove-photos': fc.record({ ids: fc.subarray(['a', 'b', 'c']) }),
  // Forgetting is no step; it has tests of its own.
  'forget-photos': fc.record({ ids: fc.constant([]) }),
  'use-photo': fc.record({ id: photo, use: fc.boolean() }),
  'use-photos': fc.record({ uses: fc.dictionary(photo, fc.boolean()).map((uses) => new Map(Object.entries(uses))) }),
  'exchange-photo': fc.record({ id: photo, by: fc.constantFrom('d', 'e') }),
  'choose-by': fc.record({ alike: fc.integer({ min: 4, max: 16 }), order: fc.constantFrom('time', 'name') }),
  'focus-photo': fc.record({ id: photo, focus: fc.constantFrom(null, { x: 0.2, y: 0.7 }) }),
  'star-photo': fc.record({ id: photo, on: fc.boolean() }),
  lock: fc.record({ part: fc.constantFrom('layout', 'style', 'photos'), on: fc.boolean() }),
  'want-panels': fc.record({ count: fc.constantFrom(null, 1, 4) }),
  'show-page': anId.map((id) => ({ page: page(id), pageId: id })),
  'change-page': anId.map((id) => ({ page: page(id) })),
  'change-settings': anId.map((id) => ({ page: page(id), settings: { ...DEFAULT_SETTINGS, gutter: id / 100 } })),
  'set-sheets': fc.tuple(fc.uniqueArray(anId, { minLength: 1, maxLength: 4 }), fc.nat({ max: 3 })).map(([ids, at]) => ({
    sheets: ids.map((id) => ({ page: page(id), pageId: id + 10, sheet: id })),
    at: at % ids.length,
  })),
  'no-page': fc.constant({}),
  design: fc.constantFrom(
    { draft: null },
    { draft: { id: 'd', name: 'D', tags: [], background: [], foreground: [], ink: '#000000' } },
  ),
  'own-styles': items.map((mine) => ({ mine })),
  favourites: items.map((favourites) => ({ favourites })),
  'own-layouts': items.map((ownLayouts) => ({ ownLayouts })),
  'love-page': fc.record({ pageId: anId, on: fc.boolean() }),
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

describe('whatever is done', () => {
  test('undoing everything leads to the start, and redoing everything back', () => {
    fc.assert(
      fc.property(changes, (list) => {
        const end = play(EMPTY_HISTORY, ...list);
        let back = end;
        while (back.past.length > 0) back = advance(back, { type: 'undo' });
        expect(back.present).toEqual(EMPTY_HISTORY.present);
        let forth = back;
        while (forth.future.length > end.future.length) forth = advance(forth, { type: 'redo' });
        expect(forth.present).toEqual(end.present);
      }),
    );
  });

  test('two hundred steps go back one by one, and forth again', () => {
    fc.assert(
      fc.property(fc.array(action, { minLength: 600, maxLength: 640 }), (list) => {
        const states = [EMPTY_HISTORY];
        for (const one of list) {
          const next = advance(states[states.length - 1], one);
          // A gesture that goes on amends its step.
          if (next.past.length > states[states.length - 1].past.length) states.push(next);
          else states[states.length - 1] = next;
        }
        // Some actions change nothing, and more steps than are kept say nothing either.
        fc.pre(states.length > 200 && states.length <= 500);
        let now = states[states.length - 1];
        for (const before of states.slice(0, -1).reverse()) {
          now = advance(now, { type: 'undo' });
          expect(now.present).toEqual(before.present);
        }
        for (const after of states.slice(1)) {
          now = advance(now, { type: 'redo' });
          expect(now.present).toEqual(after.present);
        }
      }),
      { numRuns: 20 },
    );
  });

  test('the page is among those shown, no page is shown twice, and a fresh id is fresh', () => {
    fc.assert(
      fc.property(changes, (list) => {
        const history = play(EMPTY_HISTORY, ...list);
        const ids = history.shown.map(({ id }) => id);
        expect(new Set(ids).size).toBe(ids.length);
        if (history.present.page) expect(position(history)).toBeGreaterThanOrEqual(0);
        expect(ids).not.toContain(freshPageId(history));
      }),
    );
  });

  test('nothing is changed in place', () => {
    fc.assert(
      fc.property(changes, changes, (first, second) => {
        const before = play(EMPTY_HISTORY, ...first);
        const copy = structuredClone(before);
        play(before, ...second);
        expect(before).toEqual(copy);
      }),
    );
  });
});
