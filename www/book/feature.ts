/** The pages of a project. */

import { lazyWorkspace } from '../ui/lazy.tsx';
import { untracked } from '@preact/signals';
import { createBook } from './book.ts';
import { createBookActions } from './book-actions.ts';
import { createBookMaking } from './book-making.ts';
import { keepBook } from './book-upkeep.ts';
import { createShownPages } from './shown-pages.ts';
import type { Book } from './book.ts';
import type { BookMaking } from './book-making.ts';
import type { ShownPages } from './shown-pages.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  book: Book;
  bookMaking: BookMaking;
  shownPages: ShownPages;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ book: createBookActions(app) });

export const bookFeature: Feature<Parts> = {
  install(app) {
    const { ui, subjects, reading } = app;
    const book = createBook({ ...app, onKept: (page) => app.taste.learn(page) });
    return {
      book,
      bookMaking: createBookMaking({
        ...app,
        book,
        album: reading,
        places: {
          offered: () => app.placeNames.offered.peek(),
          add: () => ui.showPlaces(true),
          marked: app.placeNames.marked,
        },
        searched: () => !ui.detects || (subjects.searched.value && subjects.settled.value),
        ready: () => Promise.all([app.lettering.ready(), app.placeNames.settled()]),
      }),
      shownPages: createShownPages({ ...app, onLoved: app.taste.learn }),
    };
  },
  start(app) {
    keepBook(app);
    // Unfinished edits of a page end when another page opens.
    app.book.sheet.subscribe(() => untracked(app.leavePage));
  },
  screens: {
    pages: lazyWorkspace(async () => (await import('./pages-wall.tsx')).PagesWall),
  },
  actions,
};
