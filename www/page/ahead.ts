/**
 * Plans and draws the next page of Shuffle in advance, while the user looks at the current one. A change of the
 * project, the photos or the detection results starts it again.
 */

import { effect, signal } from '@preact/signals';
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

export type Ahead = ReturnType<typeof createAhead>;

export function createAhead({
  store,
  pages,
  ui,
  scheduler,
}: {
  store: Store;
  pages: Pick<Pages, 'prepare'>;
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
    // During an import, the page and its photos change automatically.
    const rests = photos.value.length > 0 && reading.value === null && planner.value && ui.painted.value === now;
    stop.abort();
    page.value = null;
    if (!now || !rests) return;
    stop = new AbortController();
    const prepare = () => {
      page.value = pages.prepare();
    };
    const rest = version.value === before ? REST.same : REST.another;
    before = version.value;
    scheduler.background(prepare, { rest, signal: stop.signal });
  });

  return { page: page as ReadonlySignal<PageDocument | null> };
}
