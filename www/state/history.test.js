// @ts-check
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { EMPTY_HISTORY, advance, freshPageId, position } from './history.js';
import { DEFAULT_SETTINGS } from './project.js';

/** @typedef {import('./history.js').History} History */
/** @typedef {import('./history.js').Change} Change */

/** @param {number} seed @returns {any} */
const page = (seed) => ({ version: 1, seed, layout: 'a', style: 'b', order: [], panels: [], merges: [], page: DEFAULT_SETTINGS, captions: [] });
/** @param {History} history @param {Change[]} changes */
const play = (history, ...changes) => changes.reduce(advance, history);
/** @param {number} id @returns {Change} */
const show = (id) => ({ type: 'show-page', page: page(id), pageId: id });

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
    const drag = (/** @type {number} */ gutter) => (/** @type {Change} */ ({
      type: 'change-settings', settings: { ...DEFAULT_SETTINGS, gutter }, page: page(1), gesture: 'gutter' }));
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
    const history = play(EMPTY_HISTORY, { type: 'add-photos', ids: ['a', 'b'] }, show(1),
      { type: 'forget-photos', ids: ['a'] }, { type: 'undo' });
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
    const history = play(EMPTY_HISTORY, show(1), { type: 'change-page', page: edited }, show(2), { type: 'undo' }, show(3));
    expect(history.shown.map(({ id }) => id)).toEqual([1, 2, 3]);
    expect(history.shown[0].page.seed).toBe(99);
    expect(position(history)).toBe(2);
  });

  test('going back to a page is a step, and leaves the list as it is', () => {
    const history = play(EMPTY_HISTORY, show(1), show(2), show(1));
    expect(history.shown.length).toBe(2);
    expect(position(history)).toBe(0);
    expect(position(advance(history, { type: 'undo' }))).toBe(1);
  });
});

const changes = fc.array(fc.oneof(
  fc.integer({ min: 1, max: 9 }).map(show),
  fc.constantFrom('undo', 'redo').map((type) => /** @type {Change} */ ({ type })),
  fc.tuple(fc.constantFrom('layout', 'style', 'photos'), fc.boolean()).map(([part, on]) => /** @type {Change} */ ({ type: 'lock', part, on })),
  fc.subarray(['a', 'b', 'c']).map((ids) => /** @type {Change} */ ({ type: 'add-photos', ids })),
  fc.constantFrom('a', 'b', 'c').map((id) => /** @type {Change} */ ({ type: 'remove-photo', id })),
  fc.tuple(fc.constantFrom('a', 'b', 'c'), fc.boolean()).map(([id, use]) => /** @type {Change} */ ({ type: 'use-photo', id, use })),
), { maxLength: 40 });

describe('whatever is done', () => {
  test('undoing everything leads to the start, and redoing everything back', () => {
    fc.assert(fc.property(changes, (list) => {
      const end = play(EMPTY_HISTORY, ...list);
      let back = end;
      while (back.past.length > 0) back = advance(back, { type: 'undo' });
      expect(back.present).toEqual(EMPTY_HISTORY.present);
      let forth = back;
      while (forth.future.length > end.future.length) forth = advance(forth, { type: 'redo' });
      expect(forth.present).toEqual(end.present);
    }));
  });

  test('the page is among those shown, no page is shown twice, and a fresh id is fresh', () => {
    fc.assert(fc.property(changes, (list) => {
      const history = play(EMPTY_HISTORY, ...list);
      const ids = history.shown.map(({ id }) => id);
      expect(new Set(ids).size).toBe(ids.length);
      if (history.present.page) expect(position(history)).toBeGreaterThanOrEqual(0);
      expect(ids).not.toContain(freshPageId(history));
    }));
  });

  test('nothing is changed in place', () => {
    fc.assert(fc.property(changes, changes, (first, second) => {
      const before = play(EMPTY_HISTORY, ...first);
      const copy = structuredClone(before);
      play(before, ...second);
      expect(before).toEqual(copy);
    }));
  });
});
