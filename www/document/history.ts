/**
 * Undo and redo as lists of complete states with ids instead of pixels, and the page history. Undo does not remove
 * pages from the page history. The core changes them (`crates/engine/src/document/editor.rs`).
 */

import { EMPTY_PROJECT } from './empty.ts';
import type { Edit, History, How, Shown } from '../engine/types.ts';

export type { History, Shown };

/**
 * A change of the history: an edit with its recording mode, or undo and redo. `silent` amends the present without an
 * undo step, for example while a page is still being completed. A step joins the step before if both have the same
 * `gesture`. `share` replaces lists that all projects share with their current version, without an undo step. `join`
 * does the same, but items of this project stay.
 */
export type Change = Edit & How;

export const EMPTY_HISTORY: History = Object.freeze({
  past: Object.freeze([]),
  present: EMPTY_PROJECT,
  future: Object.freeze([]),
  shown: Object.freeze([]),
});
