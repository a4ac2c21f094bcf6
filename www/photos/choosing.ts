/**
 * Which photos are used and in which order: how alike two may be, which of a stack, by time or by name. The page
 * shows the answer at once, and each change is one step of the undo.
 */

import type { Pages } from '../document/pages.ts';
import type { Order } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/documents.ts';
import type { Reading } from './reading.ts';

export type Choosing = ReturnType<typeof createChoosing>;

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

export function createChoosing({ store, pages, reading }: { store: Store; pages: Pages; reading: Reading }) {
  return { setAlike, setOrder, take };

  /** @param alike bits of a fingerprint, 4 to 16 */
  function setAlike(alike: number) {
    const before = store.photos.peek().length;
    reading.edit(
      { type: 'choose-by', alike },
      () => pages.refit({ grow: store.photos.peek().length > before }),
      'alike',
    );
  }

  function setOrder(order: Order) {
    reading.edit({ type: 'choose-by', order }, () => {
      const { page, locks } = store.project.peek();
      return page && !locks.photos
        ? replanned(
            resorted(
              page,
              store.photos.peek().map(({ id }) => id),
            ),
          )
        : undefined;
    });
  }

  /**
   * Takes one photo in place of those that look like it, on the page too.
   * @param alike the whole stack
   */
  function take(id: string, alike: readonly string[]) {
    const uses = new Map(alike.map((other) => [other, other === id]));
    reading.edit({ type: 'use-photos', uses }, () => {
      const { page } = store.project.peek();
      return page && replanned(exchanged(page, id, alike));
    });
  }

  function replanned(page: PageDocument) {
    return pages.plan({ keep: KEEP_ALL, current: page, seed: page.seed });
  }
}

/** The page with one photo wherever it shows another of a stack, but in locked panels. */
export function exchanged(page: PageDocument, id: string, alike: readonly string[]): PageDocument {
  const swap = (photo: string) => (alike.includes(photo) ? id : photo);
  const panels = page.panels.map((panel) =>
    panel.locked || panel.photo === null || !alike.includes(panel.photo)
      ? panel
      : { ...panel, photo: id, crop: null, edited: false },
  );
  return { ...page, panels, order: [...new Set(page.order.map(swap))] };
}

/**
 * The page with the same photos in another order, locked panels apart.
 * @param ids all photos in use, in that order
 */
export function resorted(page: PageDocument, ids: readonly string[]): PageDocument {
  const rank = (id: string | null) => (id === null ? Infinity : ids.indexOf(id));
  const leader = (i: number) => page.merges.find((group) => group.includes(i))?.[0] ?? i;
  const free = page.panels.map((_, i) => i).filter((i) => leader(i) === i && !page.panels[i].locked);
  const photos = free.map((i) => page.panels[i].photo).sort((a, b) => rank(a) - rank(b));
  const panels = page.panels.map((panel, i) => {
    const at = free.indexOf(leader(i));
    if (at < 0 || photos[at] === panel.photo) return panel;
    return { ...panel, photo: photos[at], crop: null, edited: false };
  });
  return { ...page, panels, order: [...page.order].sort((a, b) => rank(a) - rank(b)) };
}
