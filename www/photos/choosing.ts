/**
 * Selects photos and their order: similarity, choice within a stack, order by time or name. The page shows the answer
 * at once, and each change is one step of the undo.
 */

import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { Pages } from '../document/pages.ts';
import type { Order } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Reading } from './reading.ts';

export type Choosing = ReturnType<typeof createChoosing>;

export function createChoosing({
  store,
  pages,
  reading,
  messages,
}: {
  store: Store;
  pages: Pages;
  reading: Reading;
  messages: Pick<Messages, 'note'>;
}) {
  let stars = 0;
  return { setDuplicateThreshold, setOrder, take, star };

  /** @param duplicateThreshold maximum fingerprint distance of near-duplicates, in bits, 4 to 16 */
  function setDuplicateThreshold(duplicateThreshold: number) {
    const before = store.photos.peek().length;
    reading.edit(
      { type: 'choose-by', alike: duplicateThreshold },
      (gesture) => pages.refit({ grow: store.photos.peek().length > before, gesture }),
      'alike',
    );
  }

  function setOrder(order: Order) {
    reading.edit({ type: 'choose-by', order }, (gesture) => pages.edit({ type: 'sort-photos', gesture }));
  }

  /**
   * Uses one photo instead of its near-duplicates, on the page as well.
   * @param alike the whole stack
   */
  function take(id: string, alike: readonly string[]) {
    const uses = Object.fromEntries(alike.map((other) => [other, other === id]));
    reading.edit({ type: 'use-photos', uses }, (gesture) =>
      pages.edit({ type: 'use-duplicate', photo: id, alike, gesture }),
    );
  }

  /**
   * Shuffle shows a starred photo in a large panel. Its panel on this page is enlarged if the layout allows it; nothing else of
   * the page changes. A message says why a panel keeps its size.
   */
  function star(id: string, on: boolean) {
    stars += 1;
    const gesture = `star-${stars}`;
    const enlarge = () => {
      const { page, locks } = store.project.peek();
      const panel = page?.panels.findIndex(({ photo }) => photo === id) ?? -1;
      if (!on || !page || panel < 0) return;
      const isLocked = locks.layout || page.panels[panel].locked;
      if (!pages.edit({ type: 'enlarge-panel', panel, gesture }))
        messages.note(isLocked ? strings.starLocked : strings.starKeepsSize);
    };
    reading.edit({ type: 'star-photo', id, on }, enlarge, gesture);
  }
}
