/** Photos of text, such as receipts, which a page avoids. */

import type { Store } from '../document/store.ts';
import type { PhotoMeta } from '../engine/types.ts';

/** @returns the ids of photos that are pages of text */
export function pagesOfText(
  { planner }: { planner: Pick<Store['planner'], 'peek'> },
  photos: readonly PhotoMeta[],
): ReadonlySet<string> {
  // A new project has shown no photo, so that all have a reason.
  const unseen = planner.peek()?.createEditor().plans(photos).unseen() ?? [];
  return new Set(unseen.filter(({ why }) => why === 'text').map(({ photo }) => photo));
}
