/**
 * Plans and draws the next page of Shuffle in advance, while the current one is drawn or looked at. A change of the
 * project, the photos or the detection results starts it again.
 */

import { effect, signal } from '@preact/signals';
import { nextTask } from '../engine/scheduler.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Ui } from '../ui/ui.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

/**
 * Milliseconds of rest before the next page is planned. After another page appeared, the next shuffle may come at any time.
 * Changes of the same page may follow each other in every frame, for example while a divider is dragged.
 */
const REST = { another: 0, same: 350 };
/** Milliseconds until a page in a slow style may be planned as well. Its panels occupy the workers, even after a cancellation. */
const LONG_REST = 1500;

export type Ahead = ReturnType<typeof createAhead>;

export function createAhead({
  store,
  pages,
  ui,
  scheduler,
}: {
  store: Store;
  pages: Pick<Pages, 'prepare' | 'prepareSlow'>;
  ui: Pick<Ui, 'painted'>;
  scheduler: Scheduler;
}) {
  const page: Signal<PageDocument | null> = signal(null);
  let stop = new AbortController();
  /** The version of the page that was prepared for last. */
  let before = '';

  effect(() => {
    const { project, photos, reading, planner, version } = store;
    const now = project.value.page;
    const isPainted = ui.painted.value === now;
    const isAnother = version.value !== before;
    stop.abort();
    page.value = null;
    // During an import, the page and its photos change automatically.
    if (!now || photos.value.length === 0 || reading.value !== null || !planner.value) return;
    stop = new AbortController();
    if (!isPainted) {
      if (isAnother) void planMeanwhile(stop.signal);
      return;
    }
    const { signal } = stop;
    const prepareSlow = () => {
      page.value = pages.prepareSlow() ?? page.value;
    };
    const prepare = () => {
      page.value = pages.prepare();
      scheduler.background(prepareSlow, { delay: LONG_REST, signal });
    };
    const rest = isAnother ? REST.another : REST.same;
    before = version.value;
    scheduler.background(prepare, { rest, signal });
  });

  return { page: page as ReadonlySignal<PageDocument | null> };

  /** Plans the next page while workers draw the current one. A page that is painted already is shown first. */
  async function planMeanwhile(signal: AbortSignal) {
    await nextTask();
    if (!signal.aborted && ui.painted.peek() !== store.page.peek()) pages.prepare();
  }
}
