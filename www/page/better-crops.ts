/**
 * Better crops for the shown page, after more faces or objects were detected in its photos. A page that the user has just
 * got takes them. Later they are offered, because a page should not change while the user looks at it.
 */

import { computed, effect, signal } from '@preact/signals';
import type { Ui } from '../ui/ui.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';

export type BetterCrops = ReturnType<typeof createBetterCrops>;

/** Minimum time on the screen, in milliseconds. Older pages do not change automatically. */
const LOOK = 1000;
/** Like `LOOK`, for the first page of a project before any change. Detection of a large album takes several seconds. */
const FIRST_LOOK = 10_000;
/** Minimum overlap of two crops that look equal, 0 to 1. */
const SAME = 0.9;

export function createBetterCrops({
  store,
  pages,
  ui,
  now = () => performance.now(),
}: {
  store: Store;
  pages: Pick<Pages, 'edit' | 'preview'>;
  ui: Pick<Ui, 'painted'>;
  now?: () => number;
}) {
  /** The page that is offered instead of another. */
  const offer = signal<{ of: PageDocument; better: PageDocument } | null>(null);
  /** Time when the page became visible. */
  let seen: { version: string; at: number } | null = null;

  effect(() => {
    const [page, version] = [store.page.value, store.version.value];
    if (page && ui.painted.value === page && seen?.version !== version) seen = { version, at: now() };
  });

  const offered = computed(() => (offer.value?.of === store.page.value ? (offer.value?.better ?? null) : null));

  return { offered, found, accept };

  /** Call this after something was detected in a photo of the page. */
  function found() {
    const of = store.page.peek();
    // A sketch will be planned with everything that is known by then.
    if (!of || store.sketch.peek()) return;
    if (!looked()) {
      pages.edit({ type: 'recrop', silent: true });
      offer.value = null;
      return;
    }
    const better = pages.preview({ type: 'recrop' });
    offer.value = better && differs(of, better) ? { of, better } : null;
  }

  /** Accepts the offered crops as one undo step. */
  function accept() {
    const isOffered = offered.peek() !== null;
    offer.value = null;
    if (isOffered) pages.edit({ type: 'recrop' });
  }

  /** Whether the page has been on the screen for a while. */
  function looked(): boolean {
    const look = store.canUndo.peek() ? LOOK : FIRST_LOOK;
    return seen !== null && seen.version === store.version.peek() && now() - seen.at >= look;
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
