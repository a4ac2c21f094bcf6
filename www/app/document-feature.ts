/** The project and its pages. */

import { effect } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { explain } from '../ui/explain.ts';
import { createPages } from '../document/pages.ts';
import { createStore } from '../document/store.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Feature } from '../ui/context.ts';

type Parts = {
  store: Store;
  pages: Pages;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
}

export const documentFeature: Feature<Parts> = {
  install(app) {
    const store = createStore({
      onRefused: (error) => void app.messages.alert(strings.notDone({ why: explain(error) })),
    });
    const pages = createPages(store, {
      asked: (wish) => app.taste.asked(app.styling.asked(wish)),
      narrated: (page, at) => app.narrating.narrated(page, at),
      settled: (page, before) =>
        page === before ? app.lettering.cleared(page) : app.lettering.settled(page, undefined, before),
      shuffled: () => app.hints.shuffled(),
    });
    return { store, pages };
  },
  start({ store, ui, reading, scheduler }) {
    effect(() => {
      const page = store.page.value;
      const drawing = page !== null && ui.painted.value !== page && ui.failed.value === null;
      scheduler.hold(reading.near.value || drawing);
    });
  },
  busy: ({ store }) => store.planner.value === null || store.reading.value !== null || store.fetching.value,
};
