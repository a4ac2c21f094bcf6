/**
 * Undo and redo, and the page history. Undo does not remove pages from the page history. The core has all states
 * (`crates/engine/src/document/editor.rs`). The app has a copy of the parts that it shows.
 */

import { EMPTY_PROJECT } from './empty.ts';
import type { Edit, How, Project, Shown } from '../engine/types.ts';

export type { Shown };

/**
 * A change of the history: an edit with its recording mode, or undo and redo. `silent` amends the present without an
 * undo step, for example while a page is still being completed. A step joins the step before if both have the same
 * `gesture`. `share` replaces lists that all projects share with their current version, without an undo step. `join`
 * does the same, but items of this project stay.
 */
export type Change = Edit & How;

/** A history without steps. */
export type Beginning = { present: Project; shown: readonly Shown[] };

/**
 * The copy: the present, the page history, and the number of steps to undo and to redo. `step` changes with each undo
 * step, and when one is undone or redone.
 */
export type Mirror = Beginning & { undos: number; redos: number; step: number };

export const EMPTY_MIRROR: Mirror = Object.freeze({
  present: EMPTY_PROJECT,
  shown: Object.freeze([]),
  undos: 0,
  redos: 0,
  step: 0,
});
