/**
 * All actions of the app, by feature. Only this file knows all tables. Their order is the order of the list of
 * shortcuts.
 */

import { createBookActions } from '../book/book-actions.ts';
import { createDesignerActions } from '../designer/designer-actions.ts';
import { createExplorerActions } from '../explorer/explorer-actions.ts';
import { createImitationActions } from '../imitation/imitation-actions.ts';
import { createDownloadActions } from '../export/download-actions.ts';
import { createLayoutActions } from '../layouts/layout-actions.ts';
import { createTextActions, createWordActions } from '../lettering/word-actions.ts';
import { createPageActions } from '../page/page-actions.ts';
import { createPanelActions } from '../page/panels/panel-actions.ts';
import { createPhotoActions } from '../photos/photo-actions.ts';
import { createStyleActions } from '../styles/style-actions.ts';
import { createWindowActions } from './window-actions.ts';
import type { Action, OwnKeys } from '../ui/action.ts';
import type { Parts } from '../ui/context.ts';

export type Actions = ReturnType<typeof createActions>;
/** Actions by feature, as used by the list of shortcuts and the menus. */
export type Tables = Record<string, Record<string, Action | OwnKeys>>;

export function createActions(parts: Parts) {
  return {
    page: createPageActions(parts),
    book: createBookActions(parts),
    panels: createPanelActions(parts),
    layouts: createLayoutActions(parts),
    styles: createStyleActions(parts),
    words: createWordActions(parts),
    text: createTextActions(parts),
    photos: createPhotoActions(parts),
    designer: createDesignerActions(parts),
    explorer: createExplorerActions(parts),
    imitation: createImitationActions(parts),
    download: createDownloadActions(parts),
    window: createWindowActions(parts),
  } satisfies Tables;
}

/** @returns each with its name, such as `page.shuffle` */
export function everyAction(tables: Tables): [string, Action][] {
  return Object.entries(tables).flatMap(([feature, table]) =>
    Object.entries(table).flatMap(([name, action]): [string, Action][] =>
      'run' in action ? [[`${feature}.${name}`, action]] : [],
    ),
  );
}
