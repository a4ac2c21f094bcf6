/**
 * The app object. Each feature adds its parts to `App` and its tables to `Actions` by declaration merging in its
 * `feature.ts`, so that this file knows no feature. `app/app.ts` installs the features.
 */

import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Tables } from './action.ts';
import type { LazyView } from './lazy.tsx';
import type { Work } from './ui.ts';

/** The environment of the app. `script`: the address of its first script. */
export type Env = { window: Window; script: string };

/** All parts of the app. */
export interface App {
  env: Env;
  actions: Actions;
  screens: Screens;
  /** Whether a feature does urgent work, which idle work must not delay. It reads signals. */
  busy: () => boolean;
  /** Ends everything that belongs to the open page, or to the open project. */
  leavePage: () => void;
  leaveProject: () => void;
}

/** Views that are loaded when they are first shown: the board, workspaces and dialogs. */
export type Screens = Record<'board' | 'help' | 'export' | Work, LazyView>;

/** The tables of actions. */
// biome-ignore lint/suspicious/noEmptyInterface: the features add their tables.
export interface Actions {}

/** A feature of the app. */
export type Feature<Parts extends object> = {
  /**
   * Creates its parts. They may use the parts of the features before it at once, and all others when their functions are
   * called.
   */
  install: (app: App) => Parts;
  /** Connects its parts with the window and with other features. All features are installed. */
  start?: (app: App) => void;
  actions?: (app: App) => Tables;
  screens?: Partial<Screens>;
  /** Whether it does urgent work. It reads signals. */
  busy?: (app: App) => boolean;
  /** Ends everything that belongs to the open page. */
  onLeavePage?: (app: App) => void;
  /** Ends everything that belongs to the open project. */
  onLeaveProject?: (app: App) => void;
};

export const AppContext = createContext(null as App | null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error('A view was rendered outside of AppContext.');
  return app;
}
