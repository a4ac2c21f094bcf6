/**
 * Selects photos and their order: similarity, choice within a stack, order by time or name. The page shows the answer
 * at once, and each change is one step of the undo.
 */

import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { Pages } from '../document/pages.ts';
import type { Order } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Planner } from '../engine/core.ts';
import type { LayoutChoice, PageDocument } from '../engine/types.ts';
import type { Reading } from './reading.ts';

export type Choosing = ReturnType<typeof createChoosing>;

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

/** @param app `enlarged` returns the layout with a larger panel, or null */
export function createChoosing({
  store,
  pages,
  reading,
  messages,
  enlarged,
}: {
  store: Store;
  pages: Pages;
  reading: Reading;
  messages: Pick<Messages, 'note'>;
  enlarged: (planner: Planner, page: PageDocument, panel: number) => LayoutChoice | null;
}) {
  let stars = 0;
  return { setDuplicateThreshold, setOrder, take, star };

  /** @param duplicateThreshold maximum fingerprint distance of near-duplicates, in bits, 4 to 16 */
  function setDuplicateThreshold(duplicateThreshold: number) {
    const before = store.photos.peek().length;
    reading.edit(
      { type: 'choose-by', alike: duplicateThreshold },
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
   * Uses one photo instead of its near-duplicates, on the page as well.
   * @param alike the whole stack
   */
  function take(id: string, alike: readonly string[]) {
    const uses = Object.fromEntries(alike.map((other) => [other, other === id]));
    reading.edit({ type: 'use-photos', uses }, () => {
      const { page } = store.project.peek();
      return page && replanned(exchanged(page, id, alike));
    });
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
      const planner = store.planner.peek();
      const panel = page?.panels.findIndex(({ photo }) => photo === id) ?? -1;
      if (!on || !page || !planner || panel < 0) return undefined;
      const isLocked = locks.layout || page.panels[panel].locked;
      const layout = isLocked ? null : enlarged(planner, page, panel);
      if (layout) pages.amend({ ...page, layout }, { gesture });
      else messages.note(isLocked ? strings.starLocked : strings.starKeepsSize);
      return undefined;
    };
    reading.edit({ type: 'star-photo', id, on }, enlarge, gesture);
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
  const leader = (i: number) => groupOf(page, i)[0];
  const free = leaders(page).filter((i) => !page.panels[i].locked);
  const photos = free.map((i) => page.panels[i].photo).sort((a, b) => rank(a) - rank(b));
  const panels = page.panels.map((panel, i) => {
    const at = free.indexOf(leader(i));
    if (at < 0 || photos[at] === panel.photo) return panel;
    return { ...panel, photo: photos[at], crop: null, edited: false };
  });
  return { ...page, panels, order: [...page.order].sort((a, b) => rank(a) - rank(b)) };
}

/** @returns the panels that share an image with that one, itself among them */
function groupOf({ merges }: PageDocument, panel: number): readonly number[] {
  return merges.find((panels) => panels.includes(panel)) ?? [panel];
}

/** @returns of the panels that share an image the first, and all others */
function leaders(page: PageDocument): number[] {
  return page.panels.map((_, i) => i).filter((i) => groupOf(page, i)[0] === i);
}
