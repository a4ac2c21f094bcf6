/** Layouts of the user. */

import { createLayoutActions } from './layout-actions.ts';
import { createOwnLayouts } from './own-layouts.ts';
import type { OwnLayouts } from './own-layouts.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  ownLayouts: OwnLayouts;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ layouts: createLayoutActions(app) });

export const layoutsFeature: Feature<Parts> = {
  install: (app) => ({ ownLayouts: createOwnLayouts(app) }),
  actions,
};
