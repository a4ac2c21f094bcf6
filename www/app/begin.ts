/** The start of the app: the database is read while the core is compiled. */

import { unreadMeta } from '../document/album.ts';
import { strings } from '../strings/strings.ts';
import { explain } from '../ui/explain.ts';
import { createArrivals } from './arrivals.ts';
import type { App } from '../ui/context.ts';

/** Minimum milliseconds until screens are loaded that the user has not opened. */
const SCREENS_AFTER = 3_000;
const ANY_PAGE = { layout: false, style: false, photos: false };
/** Number of plans while the user chooses photos, milliseconds between them, and number of photos in each plan. */
const [PLANS, BETWEEN, ALBUM] = [6, 100, 24];

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
  void engine.warm([0, 1, 2, 3].flatMap((seed) => planAny(store, seed, ['warm']) ?? []));
}

/** Plans pages while the user chooses photos, so that the browser optimises the planner. */
export function warmPlanner({ store, scheduler }: Pick<App, 'store' | 'scheduler'>) {
  const ids = Array.from({ length: ALBUM }, (_, i) => `warm-${i}`);
  for (let i = 0; i < PLANS; i += 1)
    scheduler.background(() => planAny(store, i, ids), { rest: 0, delay: BETWEEN * i });
}

/** @param ids of photos that are not read */
function planAny(store: App['store'], seed: number, ids: readonly string[]) {
  const photos = ids.map((id) => unreadMeta(id));
  const page = store.project.peek().settings;
  return store.planner.peek()?.plan({ seed, photos, page, current: null, keep: ANY_PAGE });
}
