/**
 * Options of Shuffle for styles: it also uses custom and favourite styles, generates some, and can retain a layer of
 * the page.
 */

import type { Styling } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Wish } from '../engine/core.ts';
import type { Style } from '../engine/types.ts';
import type { OwnStyles } from './own-styles.ts';

export type StylingDeeds = ReturnType<typeof createStyling>;

export function createStyling({
  store,
  ownStyles,
  inventions = () => [],
}: {
  store: Store;
  ownStyles: Pick<OwnStyles, 'mine' | 'favourites'>;
  /** Invented styles that were tried on photos of the page. */
  inventions?: () => readonly Style[];
}) {
  return { asked, change };

  /** A wish for a page whose style is drawn like that. */
  function asked(wish: Wish): Wish {
    // A retained or fixed style is not chosen at random, so the core does not need the other styles.
    if (wish.keep.style || wish.style !== undefined) return wish;
    const { invented, keepLines, keepColours } = store.project.peek().styling;
    const mine = ownStyles.mine.peek();
    const extra = [...mine, ...ownStyles.favourites.peek().filter(({ id }) => mine.every((style) => style.id !== id))];
    return { ...wish, styling: { extra, invented, inventions: [...inventions()], keepLines, keepColours } };
  }

  /** @param gesture names one drag of a control, which is one step of the undo */
  function change(wish: Partial<Styling>, gesture?: string) {
    store.change({ type: 'styling', styling: { ...store.project.peek().styling, ...wish }, gesture });
  }
}
