/** Invented styles: the explorer, and styles for Shuffle. */

import { lazyWorkspace } from '../ui/lazy.tsx';
import { freshSeed } from '../document/pages.ts';
import { createExplorer } from './explorer.ts';
import { createExplorerActions } from './explorer-actions.ts';
import { createInventions } from './inventions.ts';
import type { Explorer } from './explorer.ts';
import type { Inventions } from './inventions.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  explorer: Explorer;
  inventions: Inventions;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ explorer: createExplorerActions(app) });

export const explorerFeature: Feature<Parts> = {
  install(app) {
    const { store, ui, subjects, masks } = app;
    const options = { seed: freshSeed, judged: ui.detects };
    // After the subjects, because the page shows those.
    const idle = () => ui.painted.value === store.page.value && subjects.settled.value && masks.settled.value;
    return {
      explorer: createExplorer({ ...app, ...options }),
      inventions: createInventions({ ...app, ...options, idle }),
    };
  },
  onLeaveProject: ({ explorer }) => explorer.stop(),
  screens: {
    explorer: lazyWorkspace(async () => (await import('./explorer-screen.tsx')).Explorer),
  },
  actions,
};
