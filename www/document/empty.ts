/** An empty project. `cargo xtask bless` generates this file from `crates/model/src/project.rs`. */

import type { Project } from './project.ts';

/** Default settings of a page. */
export const DEFAULT_SETTINGS = Object.freeze({
  width: 2480,
  height: 3508,
  dpi: 300,
  gutter: 0.018,
  margin: 0.027,
  border: 0.004,
  cornerRadius: 0,
  paper: '#ffffff',
  borderColor: '#111111',
  forScreens: true,
});

export const EMPTY_PROJECT: Project = Object.freeze({
  name: '',
  tray: Object.freeze([]),
  alike: 10,
  order: 'time',
  locks: Object.freeze({ layout: false, style: false, photos: false }),
  panels: null,
  settings: DEFAULT_SETTINGS,
  page: null,
  pageId: 0,
  sheet: 0,
  others: Object.freeze([]),
  at: 0,
  draft: null,
  mine: Object.freeze([]),
  favourites: Object.freeze([]),
  ownLayouts: Object.freeze([]),
  loved: Object.freeze([]),
  styling: Object.freeze({ invented: 0.15, keepLines: false, keepColours: false }),
});
