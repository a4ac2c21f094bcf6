/** The search for the style of a picture. */

import { lazyWorkspace } from '../ui/lazy.tsx';
import { freshSeed } from '../document/pages.ts';
import { freshStyleId } from '../styles/own-styles.ts';
import { createImitation } from './imitation.ts';
import { createImitationActions } from './imitation-actions.ts';
import type { Imitation } from './imitation.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  imitation: Imitation;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ imitation: createImitationActions(app) });

export const imitationFeature: Feature<Parts> = {
  install: (app) => ({ imitation: createImitation({ ...app, seed: freshSeed, freshId: freshStyleId }) }),
  onLeaveProject: ({ imitation }) => imitation.clear(),
  screens: {
    imitation: lazyWorkspace(async () => (await import('./imitation-screen.tsx')).ImitationScreen),
  },
  actions,
};
