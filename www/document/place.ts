/** Storage place of a project. */

import { freshId } from './fresh-id.ts';
import type { History } from './history.ts';

/**
 * `stamp` identifies the last write, empty before the first. Saving updates it here. The object identifies the project
 * while it is open. `stored` is the history in the database, if the journal has a newer one.
 */
export type Place = { readonly id: string; readonly created: number; stamp: string; readonly stored?: History };

/** @returns the place of a project that is not stored yet */
export function freshPlace(): Place {
  return { id: freshId(), created: Date.now(), stamp: '' };
}
