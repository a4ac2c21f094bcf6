/**
 * Crops that became better after a page was shown, because detection found more in its photos. If the user has seen the
 * page, it does not change automatically, and the app offers the new crops.
 */

import { computed, effect, signal } from '@preact/signals';
import type { Ui } from '../app/ui.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';

export type BetterCrops = ReturnType<typeof createBetterCrops>;

/** Minimum time on the screen, in milliseconds, for a page that counts as seen. */
const LOOK = 1000;
/** Minimum overlap of two crops that look equal, 0 to 1. */
const SAME = 0.9;

export function createBetterCrops({
  store,
  pages,
  ui,
  now = () => performance.now(),
}: {
  store: Store;
  pages: Pick<Pages, 'refined'>;
  ui: Pick<Ui, 'painted'>;
  now?: () => number;
}) {
  /** The page that is offered to replace another one. */
  const offer = signal<{ of: PageDocument; better: PageDocument } | null>(null);
  /** When the page came to the screen. */
  let seen: { version: string; at: number } | null = null;

  effect(() => {
    const [page, version] = [store.page.value, store.version.value];
    if (page && ui.painted.value === page && seen?.version !== version) seen = { version, at: now() };
  });

  const offered = computed(() => (offer.value?.of === store.page.value ? (offer.value?.better ?? null) : null));

  return { offered, found, accept };

  /** Detection has found more in a photo of the page. */
  function found() {
    const of = store.page.peek();
    // A sketch is planned with all current results.
    if (!of || store.sketch.peek()) return;
    const better = pages.refined();
    if (better && !looked()) store.change({ type: 'change-page', page: better, silent: true });
    else offer.value = better && differs(of, better) ? { of, better } : null;
  }

  /** Applies the offered page as one undo step. */
  function accept() {
    const better = offered.peek();
    offer.value = null;
    if (better) store.change({ type: 'change-page', page: better });
  }

  /** Whether the user has seen the page. */
  function looked(): boolean {
    return seen !== null && seen.version === store.version.peek() && now() - seen.at >= LOOK;
  }
}

/** Whether the change of a panel is visible. */
function differs(before: PageDocument, after: PageDocument): boolean {
  return after.panels.some(({ photo, crop }, i) => {
    const was = before.panels[i];
    if (photo !== was.photo || !crop || !was.crop) return photo !== was.photo || crop !== was.crop;
    return overlap(crop, was.crop) < SAME;
  });
}

/** @returns the intersection of two crops divided by their union, 0 to 1 */
function overlap(a: Bounds, b: Bounds): number {
  const side = (from: number, length: number, other: number, its: number) =>
    Math.max(0, Math.min(from + length, other + its) - Math.max(from, other));
  const both = side(a.x, a.width, b.x, b.width) * side(a.y, a.height, b.y, b.height);
  return both / Math.max(Number.EPSILON, a.width * a.height + b.width * b.height - both);
}
