// @ts-check
/**
 * The lists that all projects have in common: a person's own styles, favourites and layouts. They are a part of each
 * project, so that undo reaches them; what another project or another tab did to them is carried into every state of
 * the history, so that no undo here takes it back.
 */

import { MOST } from './limits.js';

/** @typedef {import('./history.js').History} History */
/** @typedef {import('./project.js').Project} Project */
/** @typedef {Pick<Project, 'mine' | 'favourites' | 'ownLayouts'>} SharedLists */
/** @typedef {{ id: string }} Item */

/** @type {readonly (keyof SharedLists)[]} */
export const SHARED = ['mine', 'favourites', 'ownLayouts'];

/**
 * @param {History} history
 * @param {Partial<SharedLists>} lists as they are now
 * @returns {History} the same object when it had them already
 */
export function rebased(history, lists) {
  const news = SHARED.filter((field) => lists[field] !== undefined && !same(lists[field], history.present[field]));
  if (news.length === 0) return history;
  /** A list that many states share stays shared. @type {Map<unknown, readonly Item[]>} */
  const made = new Map();
  const carry = (/** @type {Project} */ project) => {
    const changed = news.map((field) => {
      const list = project[field];
      const known = made.get(list) ?? carried(list, history.present[field], /** @type {readonly Item[]} */ (lists[field]));
      made.set(list, known);
      return [field, known];
    });
    return { ...project, ...Object.fromEntries(changed) };
  };
  return { ...history, past: history.past.map(carry), present: carry(history.present), future: history.future.map(carry) };
}

/**
 * What was done between two states of a list, done to another state of it.
 * @template {Item} T
 * @param {readonly T[]} list
 * @param {readonly T[]} before
 * @param {readonly T[]} after
 * @returns {readonly T[]}
 */
export function carried(list, before, after) {
  if (same(list, before)) return after;
  const was = new Map(before.map((item) => [item.id, item]));
  const is = new Map(after.map((item) => [item.id, item]));
  const fresh = after.filter((item) => !same(item, was.get(item.id)));
  const touched = new Set([...fresh.map(({ id }) => id), ...before.filter(({ id }) => !is.has(id)).map(({ id }) => id)]);
  if (touched.size === 0) return list;
  return [...fresh, ...list.filter(({ id }) => !touched.has(id))].slice(0, MOST.styles);
}

/**
 * @param {SharedLists} project whose own styles and layouts are added
 * @param {Partial<SharedLists>} lists
 * @returns {Partial<SharedLists>}
 */
export function joined(project, lists) {
  return Object.fromEntries(SHARED.map((field) => {
    const there = new Set(lists[field]?.map(({ id }) => id));
    return [field, [...(lists[field] ?? []), ...project[field].filter(({ id }) => !there.has(id))].slice(0, MOST.styles)];
  }));
}

/** @param {unknown} a @param {unknown} b */
function same(a, b) {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
