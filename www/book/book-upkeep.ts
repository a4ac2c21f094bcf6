/**
 * Keeps inactive pages of a storyboard consistent with the photos: an excluded photo is removed from all pages
 * immediately. Their crops are updated to new detections in idle time. Neither is a separate undo step: the removal
 * belongs to the step that excluded the photo, and the new crops are a silent edit.
 */

import { effect, untracked } from '@preact/signals';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { PageDocument } from '../engine/types.ts';
import type { PhotoMeta } from '../engine/types.ts';

/** Minimum time in ms for further detections before crops are updated. */
const DELAY = 400;

export function keepBook({
  store,
  pages,
  scheduler,
}: {
  store: Store;
  pages: Pick<Pages, 'edit' | 'repair'>;
  scheduler: Pick<Scheduler, 'background'>;
}) {
  /** Measurements of the photos of a page when its crops were made. */
  const known: WeakMap<PageDocument, string> = new WeakMap();
  let waiting = false;

  effect(() => {
    const { others, page } = store.project.value;
    const photos = store.photos.value;
    if (others.length === 0 || !store.planner.value) return;
    untracked(() => {
      const byId = new Map(photos.map((photo) => [photo.id, photo]));
      pages.repair();
      const stale = remember(byId);
      // The edited page is updated automatically, and is up to date when the user leaves it.
      if (page) known.set(page, essence(page, byId));
      if (stale) refineLater();
    });
  });

  function refineLater() {
    if (!waiting) scheduler.background(refineOne, { delay: DELAY });
    waiting = true;
  }

  /**
   * Notes pages that are new here.
   * @param photos in use
   * @returns whether a page has crops from older measurements
   */
  function remember(photos: Map<string, PhotoMeta>): boolean {
    let stale = false;
    for (const { page } of store.project.peek().others) {
      if (!known.has(page)) known.set(page, essence(page, photos));
      stale ||= known.get(page) !== essence(page, photos);
    }
    return stale;
  }

  /** Updates the crops of one page, and then of the next. */
  function refineOne() {
    waiting = false;
    const project = store.project.peek();
    const photos = new Map(store.photos.peek().map((photo) => [photo.id, photo]));
    const stale = project.others.find(({ page }) => known.has(page) && known.get(page) !== essence(page, photos));
    if (!stale || store.reading.peek()) return;
    known.set(stale.page, essence(stale.page, photos));
    pages.edit({ type: 'recrop', sheet: stale.sheet, silent: true });
    if (remember(photos)) refineLater();
  }
}

/**
 * @param photos in use
 * @returns all that crops of the page depend on
 */
function essence({ panels }: PageDocument, photos: ReadonlyMap<string, PhotoMeta>): string {
  return JSON.stringify(
    panels.map(({ photo }) => {
      const { width, height, subjects, focus } = photos.get(photo ?? '') ?? {};
      return [photo, width, height, subjects, focus];
    }),
  );
}
