/** The start of the app: the database is read while the core is compiled. */

import { unreadMeta } from '../document/album.ts';
import { strings } from '../strings/strings.ts';
import { explain } from '../ui/explain.ts';
import { createArrivals } from './arrivals.ts';
import type { App } from '../ui/context.ts';

export function begin(app: App) {
  const { engine, store, shelves, keeping, messages, scheduler, openStyleLink, env } = app;
  const arrivals = createArrivals({ ...app, window: env.window });
  const begun = keeping.begin();
  engine.ready.then(
    (planner) => {
      store.planner.value = planner;
      shelves.recall();
      void begun.then(openStyleLink);
      void begun.then(arrivals.begin);
      scheduler.background(() => warmUp(app), { rest: 0 });
    },
    (error) => {
      keeping.running.value = false;
      messages.grave(strings.coreFailed(explain(error)));
    },
  );
}

/** Reads the catalogues and compiles the code while the app is idle, so that the first page does not wait for them. */
function warmUp({ store, engine }: App) {
  store.layouts.peek();
  store.styles.peek();
  const planner = store.planner.peek();
  if (!planner) return;
  const keep = { layout: false, style: false, photos: false };
  const plan = (seed: number) =>
    planner.plan({ seed, photos: [unreadMeta('warm')], page: store.project.peek().settings, current: null, keep });
  void engine.warm([0, 1, 2, 3].map(plan));
}
