// @ts-check
/**
 * Undo and redo as lists of whole projects (ids only, never pixels, so a project is small), and the pages shown
 * so far, which are kept even when an undo goes back before them: what was loved a minute ago is never lost.
 */

import { EMPTY_PROJECT, reduce } from './project.js';
import { rebased } from './shared-lists.js';

/** @typedef {import('./project.js').Project} Project */
/** @typedef {import('./project.js').Action} Action */
/** @typedef {import('./project.js').PageDocument} PageDocument */
/** A page that was shown; `from` is the page that it was made from. @typedef {{ id: number, page: PageDocument, from?: number }} Shown */

/**
 * @typedef {{
 *   past: readonly Project[], present: Project, future: readonly Project[], shown: readonly Shown[],
 *   gesture: string | null,
 * }} History `gesture` names the edit that the last step belongs to, such as one drag of a slider
 */

/**
 * What happens to a history: an action on the project, with how it counts, or a step through time.
 * `silent` amends the present without a step (a page that is still growing); a step with the `gesture` of the
 * step before joins it.
 * `share` tells a list that all projects have in common, as it is now outside of this one: no step, at no time undone.
 * @typedef {(
 *   | Action & { silent?: boolean, gesture?: string } | { type: 'undo' } | { type: 'redo' }
 *   | { type: 'share', lists: Partial<import('./shared-lists.js').SharedLists> }
 * )} Change
 */

const MOST_STEPS = 500;
/** Beyond so many the oldest go, favourites never. */
const MOST_SHOWN = 1000;

/** @type {History} */
export const EMPTY_HISTORY = Object.freeze({
  past: Object.freeze([]),
  present: EMPTY_PROJECT,
  future: Object.freeze([]),
  shown: Object.freeze([]),
  gesture: null,
});

/**
 * @param {History} history
 * @param {Change} change
 * @returns {History} the same object when nothing changed
 */
export function advance(history, change) {
  if (change.type === 'undo') return undo(history);
  if (change.type === 'redo') return redo(history);
  if (change.type === 'share') return rebased(history, change.lists);
  if (change.type === 'forget-photos') return forget(history, change);
  const present = reduce(history.present, change);
  if (present === history.present) return history;
  const shown = note(history.shown, present, history.present.page ? history.present.pageId : undefined);
  if (change.silent) return { ...history, present, shown };
  const joins = change.gesture !== undefined && change.gesture === history.gesture;
  const past = joins ? history.past : [...history.past, history.present].slice(-MOST_STEPS);
  return { past, present, future: [], shown, gesture: change.gesture ?? null };
}

/**
 * @param {History} history
 * @returns {number} where the present page is among those shown, -1 when there is none
 */
export function position({ shown, present }) {
  return present.page === null ? -1 : shown.findIndex(({ id }) => id === present.pageId);
}

/**
 * @param {History} history
 * @returns {number} a page id that was never used
 */
export function freshPageId({ shown, past, present, future }) {
  const ids = [...shown.map(({ id }) => id), ...[...past, present, ...future].map(({ pageId }) => pageId)];
  return ids.reduce((most, id) => Math.max(most, id), 0) + 1;
}

/** @param {History} history @returns {History} */
function undo(history) {
  const present = history.past.at(-1);
  if (!present) return history;
  const past = history.past.slice(0, -1);
  return { past, present, future: [history.present, ...history.future], shown: note(history.shown, present), gesture: null };
}

/** @param {History} history @returns {History} */
function redo(history) {
  const [present, ...future] = history.future;
  if (!present) return history;
  return { past: [...history.past, history.present], present, future, shown: note(history.shown, present), gesture: null };
}

/**
 * A photo that could not be read is gone from all times: no undo brings it back.
 * @param {History} history
 * @param {Action} change
 * @returns {History}
 */
function forget(history, change) {
  const present = reduce(history.present, change);
  if (present === history.present) return history;
  const all = (/** @type {readonly Project[]} */ list) => list.map((project) => reduce(project, change));
  const past = all(history.past);
  // A step that did nothing but add such photos is no step any more.
  while (past.length > 0 && JSON.stringify(past.at(-1)) === JSON.stringify(present)) past.pop();
  return { ...history, past, present, future: all(history.future) };
}

/**
 * The last state of each page counts: an edited page replaces itself, a new one goes to the end.
 * @param {readonly Shown[]} shown
 * @param {Project} project
 * @param {number} [from] the page before it
 * @returns {readonly Shown[]}
 */
function note(shown, { page, pageId, loved }, from) {
  if (page === null) return shown;
  const at = shown.findIndex(({ id }) => id === pageId);
  if (at < 0) {
    const all = [...shown, from === undefined ? { id: pageId, page } : { id: pageId, page, from }];
    if (all.length <= MOST_SHOWN) return all;
    const oldest = all.findIndex(({ id }) => !loved.includes(id));
    return all.filter((_, i) => i !== Math.max(0, oldest));
  }
  if (shown[at].page === page) return shown;
  return shown.map((entry, i) => (i === at ? { ...entry, page } : entry));
}
