/** Storyboards. */

import { strings } from '../strings/strings.ts';
import { lazyWorkspace } from '../ui/lazy.tsx';
import { createBoards } from './boards.ts';
import { createBoardActions } from './board-actions.ts';
import type { Boards } from './boards.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  boards: Boards;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ boards: createBoardActions(app) });

export const boardsFeature: Feature<Parts> = {
  install: (app) => ({ boards: createBoards({ ...app, chooseStyle: app.pages.chooseStyle }) }),
  screens: {
    boards: lazyWorkspace(async () => (await import('./boards-screen.tsx')).BoardsScreen, strings.boards.missing),
  },
  actions,
};
