/** The corrected subject of a photo as part of the document. */

import { batch } from '@preact/signals';
import type { Store } from '../document/store.ts';

/**
 * Makes each step that was taken one of the document, so that each is undone by itself.
 * @param steps the mask after each; null where it is what was found
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
