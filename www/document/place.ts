/** Storage place of a project. */

import { freshId } from './fresh-id.ts';

/**
 * `stamp` identifies the last write, empty before the first. Saving updates it here. The object identifies the project
 * while it is open. `behind`: how the database is behind, if it is. It has the state before the edits of the journal, with
 * which the changes of the editor begin, or an unrelated state.
 */
export type Place = {
  readonly id: string;
  readonly created: number;
  stamp: string;
  readonly behind?: 'journal' | 'wholly';
};

/** @returns the place of a project that is not stored yet */
export function freshPlace(): Place {
  return { id: freshId(), created: Date.now(), stamp: '' };
}
