/** Where a project is kept. */

import { freshId } from './fresh-id.ts';
import type { History } from './history.ts';

/**
 * `stamp` is that of the last writing, empty before the first: who writes changes it here. The object itself stands for
 * the project as long as it is open. `stored` is the history that the database has of it, where the journal told of one that
 * is further.
 */
export type Place = { readonly id: string; readonly created: number; stamp: string; readonly stored?: History };

/** @returns of a project that is kept nowhere yet */
export function freshPlace(): Place {
  return { id: freshId(), created: Date.now(), stamp: '' };
}
