/** Installs the features of the app. */

import { batch } from '@preact/signals';
import { boardsFeature } from '../boards/feature.ts';
import { bookFeature } from '../book/feature.ts';
import { designerFeature } from '../designer/feature.ts';
import { documentFeature } from './document-feature.ts';
import { explorerFeature } from '../explorer/feature.ts';
import { exportFeature } from '../export/feature.ts';
import { helpFeature } from '../help/feature.ts';
import { imitationFeature } from '../imitation/feature.ts';
import { layoutsFeature } from '../layouts/feature.ts';
import { letteringFeature } from '../lettering/feature.ts';
import { motionFeature } from '../motion/feature.ts';
import { offlineFeature } from '../offline/feature.ts';
import { pageFeature } from '../page/feature.ts';
import { paintersFeature } from '../painters/feature.ts';
import { photosFeature } from '../photos/feature.ts';
import { storageFeature } from '../storage/feature.ts';
import { stylesFeature } from '../styles/feature.ts';
import { filesFeature } from './files-feature.ts';
import { windowFeature } from './window-feature.ts';
import type { Actions, App, Env, Feature } from '../ui/context.ts';

/** In the order of installation. */
const FEATURES: readonly Feature<object>[] = [
  windowFeature,
  documentFeature,
  photosFeature,
  pageFeature,
  letteringFeature,
  layoutsFeature,
  designerFeature,
  paintersFeature,
  stylesFeature,
  explorerFeature,
  imitationFeature,
  bookFeature,
  boardsFeature,
  motionFeature,
  storageFeature,
  exportFeature,
  filesFeature,
  helpFeature,
  offlineFeature,
];

/** The tables of actions in the order of the list of shortcuts. */
const TABLES: readonly (keyof Actions)[] = [
  'page',
  'book',
  'panels',
  'layouts',
  'styles',
  'words',
  'text',
  'photos',
  'designer',
  'explorer',
  'imitation',
  'boards',
  'projects',
  'download',
  'window',
];

export function createApp(env: Env): App {
  const app = {
    env,
    screens: Object.assign({}, ...FEATURES.map(({ screens }) => screens)),
    busy: () => FEATURES.some(({ busy }) => busy?.(app)),
    leavePage: () => batch(() => FEATURES.forEach(({ onLeavePage }) => onLeavePage?.(app))),
    leaveProject() {
      app.leavePage();
      for (const { onLeaveProject } of FEATURES) onLeaveProject?.(app);
    },
  } as App;
  for (const { install } of FEATURES) Object.assign(app, install(app));
  app.actions = createActions(app);
  for (const { start } of FEATURES) start?.(app);
  return app;
}

export function createActions(app: App): Actions {
  const tables = Object.assign({}, ...FEATURES.map(({ actions }) => actions?.(app))) as Actions;
  return Object.fromEntries(TABLES.map((name) => [name, tables[name]])) as unknown as Actions;
}
