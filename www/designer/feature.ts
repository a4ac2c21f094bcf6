/** The editor of styles. */

import { lazyWorkspace } from '../ui/lazy.tsx';
import { freshStyleId } from '../styles/own-styles.ts';
import { createDesigner } from './designer.ts';
import { createDesignerActions } from './designer-actions.ts';
import type { Designer } from './designer.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  designer: Designer;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ designer: createDesignerActions(app) });

export const designerFeature: Feature<Parts> = {
  install: (app) => ({ designer: createDesigner({ ...app, freshId: freshStyleId }) }),
  screens: {
    designer: lazyWorkspace(async () => (await import('./designer-screen.tsx')).Designer),
  },
  actions,
};
