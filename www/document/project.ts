/**
 * The document that a person edits, and what can be done to it. The core does it (`src/document/edit.rs`).
 * Their types are those of the core.
 *
 * A project is plain data: which photos are in the tray and used, the locks, the wanted number of panels, and the
 * page. What is known of a photo (its name, size, measures) never changes and lives in the album, so that undoing
 * an edit does not undo what was read meanwhile.
 */

import type { Edit, Part, Project, SharedLists, Styling, TrayItem } from '../engine/types.ts';

export type { Part, Project, SharedLists, Styling, TrayItem };
export type { Order, PageDocument } from '../engine/types.ts';

export const SHARED: readonly (keyof SharedLists)[] = ['mine', 'favourites', 'ownLayouts'];

/** Steps through time, and lists that come from outside, are done to no single state. */
type Outside = Extract<Edit, { type: 'undo' | 'redo' | 'share' | 'join' }>;
export type Action = Exclude<Edit, Outside>;
