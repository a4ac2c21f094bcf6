/**
 * The next page of Shuffle, planned and drawn while a person looks at the present one. Every change of the project, of the
 * photos or of what is found in them makes it another.
 */

import { effect, signal } from '@preact/signals';
import type { Ui } from '../app/ui.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

export type Ahead = ReturnType<typeof createAhead>;

/** Milliseconds that a page is looked at before the next is made: whoever shuffles quickly needs the workers himself. */
const REST = 350;

export function createAhead({
  store,
  pages,
  ui,
}: {
  store: Store;
  pages: Pick<Pages, 'prepare'>;
  ui: Pick<Ui, 'painted'>;
}) {
  const page: Signal<PageDocument | null> = signal(null);
  let timer: ReturnType<typeof setTimeout> | undefined;

  effect(() => {
    const { project, photos, reading, planner } = store;
    const now = project.value.page;
    // As long as photos come, the page and its photos change by themselves.
    const rests = photos.value.length > 0 && reading.value === null && planner.value && ui.painted.value === now;
    clearTimeout(timer);
    page.value = null;
    if (now && rests)
      timer = setTimeout(() => {
        page.value = pages.prepare();
      }, REST);
  });

  return { page: page as ReadonlySignal<PageDocument | null> };
}
