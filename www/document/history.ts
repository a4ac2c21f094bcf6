/**
 * Undo and redo as lists of whole projects (ids only, never pixels, so a project is small), and the pages shown
 * so far, which are kept even when an undo goes back before them: what was loved a minute ago is never lost. What becomes
 * of them the core decides (`src/document/editor.rs`).
 */

import { EMPTY_PROJECT } from './empty.ts';
import type { Edit, History, How, Shown } from '../engine/types.ts';

export type { History, Shown };

/**
 * What happens to a history: an action on the project, with how it counts, or a step through time.
 * `silent` amends the present without a step (a page that is still growing); a step with the `gesture` of the
 * step before joins it.
 * `share` tells lists that all projects have in common, as they are now outside of this one: no step, at no time undone;
 * `join` the same, but what this project has besides stays.
 */
export type Change = Edit & How;

export const EMPTY_HISTORY: History = Object.freeze({
  past: Object.freeze([]),
  present: EMPTY_PROJECT,
  future: Object.freeze([]),
  shown: Object.freeze([]),
});

/** @returns the pages shown so far in the place of the present one; all of them in a project of one page */
export function versions({ shown, present }: Pick<History, 'shown' | 'present'>): readonly Shown[] {
  return shown.filter(({ sheet = 0 }) => sheet === present.sheet);
}

/** @returns where the present page is among its versions, -1 when there is none */
export function position({ shown, present }: Pick<History, 'shown' | 'present'>): number {
  return present.page === null ? -1 : versions({ shown, present }).findIndex(({ id }) => id === present.pageId);
}
