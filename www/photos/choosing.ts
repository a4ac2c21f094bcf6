/**
 * Selects photos and their order: similarity, choice within a stack, order by time or name. The page shows the answer
 * at once, and each change is one step of the undo.
 */

import type { Pages } from '../document/pages.ts';
import type { Order } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Reading } from './reading.ts';

export type Choosing = ReturnType<typeof createChoosing>;

/** Size of a large panel, relative to the mean. */
const LARGE = 1.3;
const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

export function createChoosing({ store, pages, reading }: { store: Store; pages: Pages; reading: Reading }) {
  return { setAlike, setOrder, take, star };

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

  /** Moves a starred photo to the largest free panel immediately. */
  function star(id: string, on: boolean) {
    reading.edit({ type: 'star-photo', id, on }, () => {
      const { page, locks } = store.project.peek();
      const shapes = store.geometry.peek()?.panels;
      if (!on || !page || !shapes || locks.photos || !store.photos.peek().some((photo) => photo.id === id))
        return undefined;
      const starred = new Set(store.tray.peek().flatMap((item) => (item.starred && item.id !== id ? item.id : [])));
      const sizes = shapes.map(({ bounds }) => bounds.width * bounds.height);
      // If all panels are almost equal, another layout has a large one.
      const bound = locks.layout || page.panels.some(({ locked }) => locked);
      if (!bound && Math.max(...sizes) < LARGE * (sizes.reduce((sum, size) => sum + size, 0) / sizes.length))
        return pages.plan({ keep: { ...KEEP_ALL, layout: false, photos: false }, panels: leaders(page).length });
      const changed = enlarged(page, id, sizes, starred);
      return changed === page ? undefined : replanned(changed);
    });
  }

  function replanned(page: PageDocument) {
    return pages.plan({ keep: KEEP_ALL, current: page, seed: page.seed });
  }
}

/**
 * Moves a photo to its largest panel that is neither locked nor has another starred photo. The other photo takes its
 * place.
 * @param sizes of the panels
 * @param starred the other starred photos
 * @returns the same page without a larger panel
 */
export function enlarged(
  page: PageDocument,
  id: string,
  sizes: readonly number[],
  starred: ReadonlySet<string>,
): PageDocument {
  const group = (i: number) => groupOf(page, i);
  const size = (i: number) => group(i).reduce((sum, panel) => sum + sizes[panel], 0);
  const places = leaders(page);
  const photoOf = (i: number) => page.panels[i].photo;
  const free = places.filter((i) => !group(i).some((panel) => page.panels[panel].locked));
  const target = free
    .filter((i) => !starred.has(photoOf(i) ?? ''))
    .reduce((best, i) => (best < 0 || size(i) > size(best) ? i : best), -1);
  const from = places.find((i) => photoOf(i) === id) ?? -1;
  if (target < 0 || (from >= 0 && (size(from) >= size(target) || !free.includes(from)))) return page;
  const swapped = new Map([[target, id], ...(from >= 0 ? [[from, photoOf(target)] as const] : [])]);
  const panels = page.panels.map((panel, i) => {
    const leader = group(i)[0];
    return swapped.has(leader) ? { ...panel, photo: swapped.get(leader) ?? null, crop: null, edited: false } : panel;
  });
  const gone = from >= 0 ? [] : [photoOf(target)];
  return { ...page, panels, order: [...new Set([...page.order.filter((photo) => !gone.includes(photo)), id])] };
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
