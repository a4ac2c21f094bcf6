/**
 * Attributes of the body that tell other programs, such as benchmarks and tests, what the app has finished: `idle`,
 * `drawn`, `sketched`, `searched`, `detected`, `masked`.
 */

import { effect } from '@preact/signals';
import type { App } from '../ui/context.ts';

export function reportState(app: App) {
  const { store, ui, lettering, reshaping, subjects, masks, env } = app;
  const { dataset } = env.window.document.body;
  effect(() => {
    const page = store.page.value;
    // A page without photos to choose from is not shown.
    const unseen = page === null || store.tray.value.length === 0 || ui.failed.value !== null;
    const painted =
      unseen ||
      (ui.painted.value === page &&
        (lettering.words.value.length === 0 || reshaping.editing.value || ui.lettered.value === page));
    const idle = !app.busy() && painted;
    dataset.idle = String(idle);
    // The first page of a large album is drawn long before all photos are read.
    const read = store.page.value?.panels.every(({ photo }) => photo === null || store.album.value.get(photo)?.meta);
    dataset.drawn = String(painted && !!read);
    dataset.sketched = String(store.sketch.value && store.thumbnails.value.size > 0);
    // Detection improves an existing page, so it has a separate state.
    dataset.searched = String(idle && subjects.searched.value);
    dataset.detected = String(idle && subjects.settled.value);
    dataset.masked = String(idle && subjects.settled.value && masks.settled.value);
  });
}
