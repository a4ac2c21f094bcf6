/** The start of the app: the database is read while the core is compiled. */

import { unreadMeta } from '../document/album.ts';
import { strings } from '../strings/strings.ts';
import { explain } from '../ui/explain.ts';
import { createArrivals } from './arrivals.ts';
import type { App } from '../ui/context.ts';

/** Minimum milliseconds until screens are loaded that the user has not opened. */
const SCREENS_AFTER = 3_000;

export function begin(app: App) {
  const { engine, store, shelves, keeping, messages, scheduler, openStyleLink, env } = app;
  const arrivals = createArrivals({ ...app, window: env.window });
  const begun = keeping.begin();
  // The board is needed soon. If it cannot be loaded now, it is loaded again when it is shown.
  app.screens.board.preload().catch(() => {});
  engine.ready.then(
    (planner) => {
      store.planner.value = planner;
      shelves.recall();
      void begun.then(openStyleLink);
      void begun.then(arrivals.begin);
      scheduler.background(() => warmUp(app), { rest: 0 });
      scheduler.background(() => loadScreens(app), { delay: SCREENS_AFTER });
    },
    (error) => {
      keeping.running.value = false;
      messages.grave(strings.coreFailed({ why: explain(error) }));
    },
  );
}

/** Loads the other screens, so that they open at once. A screen that fails is loaded again when it is shown. */
function loadScreens({ screens }: App) {
  for (const { preload } of Object.values(screens)) preload().catch(() => {});
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
