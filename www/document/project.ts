/**
 * The document and its edits. The core does it (`crates/model/src/edit.rs`). The types come from the core.
 *
 * A project is plain data: the photos of the tray and their use, the locks, the number of panels, and the page.
 * Properties of a photo (its name, size, measurements) never change and are stored in the album, so undo does not
 * affect them.
 */

import type { Edit, Part, Project, SharedLists, Styling, TrayItem } from '../engine/types.ts';

export type { Part, Project, SharedLists, Styling, TrayItem };
export type { Order, PageDocument } from '../engine/types.ts';

export const SHARED: readonly (keyof SharedLists)[] = ['mine', 'favourites', 'ownLayouts'];

/** Edits that apply to no single state: undo, redo, and lists from other tabs. */
type Outside = Extract<Edit, { type: 'undo' | 'redo' | 'share' | 'join' }>;
export type Action = Exclude<Edit, Outside>;
