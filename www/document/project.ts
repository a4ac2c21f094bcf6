/**
 * The document that a person edits, and what can be done to it. The core does it (`src/document/edit.rs`).
 *
 * A project is plain data: which photos are in the tray and used, the locks, the wanted number of panels, and the
 * page. What is known of a photo (its name, size, measures) never changes and lives in the album, so that undoing
 * an edit does not undo what was read meanwhile.
 */

import type { Draft } from '../designer/designer-draft.ts';
import type { PageDocument, PageSettings, Style, Template } from '../engine/documents.ts';
import type { Sheet } from './sheets.ts';

export type { PageDocument };
export type Part = 'layout' | 'style' | 'photos';
/** How a shuffle draws a style: the share of invented ones, and the layers that stay. */
export type Styling = { invented: number; keepLines: boolean; keepColours: boolean };
type Locks = { layout: boolean; style: boolean; photos: boolean };

/**
 * A photo in the tray. `use` is what the person chose; null follows the selection's verdict. `focus` is the point of
 * the photo that matters, in parts of it, where a person marked one; `starred`: a person wants to see it large.
 */
export type TrayItem = {
  id: string;
  use: boolean | null;
  focus?: { x: number; y: number } | null;
  starred?: boolean;
};

/** of the photos: as they were taken where all say so, or as their files are called */
export type Order = 'time' | 'name';

/**
 * `name`: what the person calls it, empty until then; `alike`: photos whose fingerprints differ in at most so many of 64 bits show the same picture; `panels`:
 *   the wanted number, null for any; `pageId` names the page among those shown; `sheet` is its place in a storyboard
 *   of several pages, `others` are the other pages of it, `at` of which come before this one; `draft`: the style in the designer;
 *   `mine`, `favourites` and `ownLayouts`: a person's own styles and layouts, which all projects share; `loved`: the
 *   favourites among the pages shown, by their ids
 */
export type Project = {
  name: string;
  tray: readonly TrayItem[];
  alike: number;
  order: Order;
  locks: Locks;
  panels: number | null;
  settings: PageSettings;
  page: PageDocument | null;
  pageId: number;
  sheet: number;
  others: readonly Sheet[];
  at: number;
  draft: Draft | null;
  mine: readonly Style[];
  favourites: readonly Style[];
  ownLayouts: readonly Template[];
  loved: readonly number[];
  styling: Styling;
};

/** The lists that all projects have in common. They are a part of each project, so that undo reaches them. */
export type SharedLists = Pick<Project, 'mine' | 'favourites' | 'ownLayouts'>;
export const SHARED: readonly (keyof SharedLists)[] = ['mine', 'favourites', 'ownLayouts'];

export type Action =
  | { type: 'add-photos'; ids: string[] }
  | { type: 'remove-photo'; id: string }
  | { type: 'remove-photos'; ids: readonly string[] }
  | { type: 'forget-photos'; ids: string[] }
  | { type: 'use-photo'; id: string; use: boolean }
  | { type: 'use-photos'; uses: Readonly<Record<string, boolean>> }
  | { type: 'exchange-photo'; id: string; by: string }
  | { type: 'choose-by'; alike?: number; order?: Order }
  | { type: 'focus-photo'; id: string; focus: { x: number; y: number } | null }
  | { type: 'star-photo'; id: string; on: boolean }
  | { type: 'lock'; part: Part; on: boolean }
  | { type: 'want-panels'; count: number | null }
  | { type: 'show-page'; page: PageDocument; pageId: number }
  | { type: 'change-page'; page: PageDocument }
  | { type: 'change-settings'; settings: PageSettings; page: PageDocument | null }
  | { type: 'set-sheets'; sheets: readonly Sheet[]; at: number }
  | { type: 'no-page' }
  | { type: 'design'; draft: Draft | null }
  | { type: 'own-styles'; mine: readonly Style[] }
  | { type: 'favourites'; favourites: readonly Style[] }
  | { type: 'own-layouts'; ownLayouts: readonly Template[] }
  | { type: 'love-page'; pageId: number; on: boolean }
  | { type: 'rename'; name: string }
  | { type: 'styling'; styling: Styling };
