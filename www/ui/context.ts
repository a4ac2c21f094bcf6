/** Context of all views: the state, the actions and the engine. Wired in `main.tsx` only. */

import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Boards } from '../boards/boards.ts';
import type { Book } from '../book/book.ts';
import type { BookMaking } from '../book/book-making.ts';
import type { ShownPages } from '../book/shown-pages.ts';
import type { Designer } from '../designer/designer.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Explorer } from '../explorer/explorer.ts';
import type { Download } from '../export/download.ts';
import type { ExportChoice } from '../export/export-choice.ts';
import type { Imitation } from '../imitation/imitation.ts';
import type { Hints } from '../help/hints.ts';
import type { OwnLayouts } from '../layouts/own-layouts.ts';
import type { Lettering } from '../lettering/lettering.ts';
import type { Narrating } from '../lettering/narrating.ts';
import type { FilmSounds } from '../lettering/film-sounds.ts';
import type { Subtitling } from '../lettering/subtitling.ts';
import type { Installing } from '../offline/installing.ts';
import type { Alternatives } from '../page/alternatives.ts';
import type { Framing } from '../page/panels/framing.ts';
import type { Merging } from '../page/panels/merging.ts';
import type { Reshaping } from '../page/panels/reshaping.ts';
import type { Selection } from '../page/panels/selection.ts';
import type { Animatics } from '../motion/animatics.ts';
import type { RecentStyles } from '../styles/recent-styles.ts';
import type { Taste } from '../styles/taste.ts';
import type { Ahead } from '../page/ahead.ts';
import type { BetterCrops } from '../page/better-crops.ts';
import type { Choosing } from '../photos/choosing.ts';
import type { Reading } from '../photos/reading.ts';
import type { Scrubbing } from '../page/panels/scrubbing.ts';
import type { Masks } from '../photos/masks.ts';
import type { Subjects } from '../photos/subjects.ts';
import type { Keeping } from '../storage/storage.ts';
import type { OwnStyles } from '../styles/own-styles.ts';
import type { StylingDeeds } from '../styles/styling.ts';
import type { Actions } from '../app/actions.ts';
import type { Messages } from './messages.ts';
import type { Ui } from '../app/ui.ts';

/** Parts of the app, without the actions. */
export type Parts = {
  store: Store;
  pages: Pages;
  crops: BetterCrops;
  book: Book;
  bookMaking: BookMaking;
  boards: Boards;
  animatics: Animatics;
  subjects: Subjects;
  masks: Masks;
  reading: Reading;
  scrubbing: Scrubbing;
  ahead: Ahead;
  choosing: Choosing;
  recentStyles: RecentStyles;
  taste: Taste;
  selection: Selection;
  merging: Merging;
  lettering: Lettering;
  narrating: Narrating;
  subtitling: Subtitling;
  filmSounds: FilmSounds;
  intake: (files: File[]) => void;
  openProjects: (files: File[]) => void;
  installing: Installing;
  framing: Framing;
  reshaping: Reshaping;
  hints: Hints;
  ownLayouts: OwnLayouts;
  designer: Designer;
  ownStyles: OwnStyles;
  explorer: Explorer;
  imitation: Imitation;
  styling: StylingDeeds;
  keeping: Keeping;
  shownPages: ShownPages;
  download: Download;
  exportChoice: ExportChoice;
  alternatives: Alternatives;
  messages: Messages;
  ui: Ui;
  engine: Engine;
  scheduler: Scheduler;
};

export type App = Parts & { actions: Actions };

export const AppContext = createContext(null as App | null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error('A view was rendered outside of AppContext.');
  return app;
}
