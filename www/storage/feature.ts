/** Projects in the browser and in files. */

import { lazyWorkspace } from '../ui/lazy.tsx';
import { effect } from '@preact/signals';
import { openFiles } from '../photos/file-input.tsx';
import { drawn } from '../ui/drawn.ts';
import { createProjectActions } from './project-actions.ts';
import { createShelves } from './shelves.ts';
import { createKeeping } from './storage.ts';
import type { Shelves } from './shelves.ts';
import type { Keeping } from './storage.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  shelves: Shelves;
  keeping: Keeping;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ projects: createProjectActions(app) });

export const storageFeature: Feature<Parts> = {
  install(app) {
    const { ui, env } = app;
    const shelves = createShelves({ ...app, box: () => env.window.localStorage });
    const views = {
      drawn: () => drawn(ui),
      retry() {
        ui.failed.value = null;
      },
    };
    const leave = () => app.leaveProject();
    const keeping = createKeeping({ ...app, shelves, window: env.window, leave, chooseFiles: openFiles, views });
    return { shelves, keeping };
  },
  start({ shelves, keeping, store, ui, env: { window } }) {
    window.addEventListener('storage', shelves.hear);
    effect(() => {
      if (store.page.value && ui.painted.value === store.page.value) keeping.drawn();
    });
  },
  busy: ({ keeping }) => keeping.running.value || keeping.turning.value || keeping.files.progress.value !== null,
  screens: {
    projects: lazyWorkspace(async () => (await import('./projects-dialog.tsx')).Projects),
  },
  actions,
};
