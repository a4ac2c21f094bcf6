/** All parts that actions are made of, over a planner of a few lines. */

import { signal } from '@preact/signals';
import { createBoards } from '../boards/boards.ts';
import { createBook } from '../book/book.ts';
import { createShownPages } from '../book/shown-pages.ts';
import { createDesigner } from '../designer/designer.ts';
import { fakeApp } from '../document/testing.ts';
import { createExplorer } from '../explorer/explorer.ts';
import { createImitation } from '../imitation/imitation.ts';
import { createDownload } from '../export/download.ts';
import { createOwnLayouts } from '../layouts/own-layouts.ts';
import { createLettering } from '../lettering/lettering.ts';
import { createNarrating } from '../lettering/narrating.ts';
import { createFraming } from '../page/panels/framing.ts';
import { createMerging } from '../page/panels/merging.ts';
import { createReshaping } from '../page/panels/reshaping.ts';
import { createSelection } from '../page/panels/selection.ts';
import { createChoosing } from '../photos/choosing.ts';
import { createRotating } from '../photos/rotating.ts';
import { createScrubbing } from '../page/panels/scrubbing.ts';
import { createOwnStyles } from '../styles/own-styles.ts';
import { createUi } from '../ui/ui.ts';
import type { App } from '../ui/context.ts';

/** Photos of the album: enough for two pages. */
const PHOTOS = Array.from({ length: 12 }, (_, i) => `${i}.jpg`);

/** The parts, with a page on the board. */
export async function fakeParts(): Promise<App> {
  const { store, pages, messages, reading, files, scheduler } = fakeApp();
  const engine = {} as any;
  const ui = createUi({
    document: { documentElement: { dataset: {} }, querySelectorAll: () => [] },
    localStorage: { getItem: () => null, setItem: () => {} },
    matchMedia: () => ({ matches: true, addEventListener: () => {} }),
  } as any);
  const selection = createSelection({ store });
  const designer = createDesigner({ store, pages, messages, ui, freshId: () => 'mine' });
  const ownStyles = createOwnStyles({ store, messages, designer, freshId: () => 'mine' });
  const parts = {
    store,
    pages,
    messages,
    reading,
    engine,
    ui,
    selection,
    designer,
    ownStyles,
    crops: { offered: signal(null), accept: () => {} },
    masks: {
      there: signal(false),
      progress: signal(null),
      settled: signal(true),
      held: signal(false),
      stop: () => {},
      goOn: () => {},
    },
    boards: createBoards({ store, engine, chooseStyle: pages.chooseStyle }),
    exportChoice: { asked: signal(null) },
    keeping: { busy: signal(false), broken: signal(null), elsewhere: signal(null) },
    installing: { possible: signal(false), install: () => {} },
    book: createBook({ store, pages, messages }),
    shownPages: createShownPages({ store, pages }),
    merging: createMerging({ store, pages, selection }),
    framing: createFraming({ store, pages }),
    choosing: createChoosing({ store, pages, reading, messages }),
    reshaping: createReshaping({ store, pages, seed: () => 1 }),
    rotating: createRotating({ store, pages, reading, engine, messages }),
    scrubbing: createScrubbing({ store, pages, reading, engine, messages }),
    narrating: createNarrating({
      store,
      ui,
      album: { title: () => '', moments: () => new Map() },
      settled: (page) => page,
      cleared: (page) => page,
    }),
    lettering: createLettering({ store, messages, selection, load: () => new Promise(() => {}), scheduler }),
    ownLayouts: createOwnLayouts({ store, pages, messages }),
    explorer: createExplorer({ store, engine, messages, ownStyles, seed: () => 1, judged: false }),
    imitation: createImitation({ store, engine, messages, ui, seed: () => 1, freshId: () => 'mine' }),
    download: createDownload({
      store,
      pages,
      engine,
      messages,
      pageFiles: {} as any,
      shotList: () => ({}) as any,
      animatics: {} as any,
    }),
  };
  await reading.addFiles(files(...PHOTOS));
  return parts as any;
}
