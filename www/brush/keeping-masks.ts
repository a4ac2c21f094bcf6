/** The corrected subject of a photo as part of the document. */

import { batch } from '@preact/signals';
import type { Store } from '../document/store.ts';

/**
 * Adds each correction step to the document as a separate undo step.
 * @param steps the mask after each step; null for the detected mask
 */
export function keepSteps(
  store: Pick<Store, 'album' | 'tray' | 'change'>,
  id: string,
  steps: readonly (string | null)[],
) {
  // The photo may have been removed meanwhile.
  if (!store.tray.peek().some((item) => item.id === id)) return;
  const found = store.album.peek().get(id)?.meta?.mask;
  batch(() => steps.forEach((mask) => store.change({ type: 'mask-photo', id, mask, ...(found && { found }) })));
}
