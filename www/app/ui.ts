/**
 * What the window looks like: never part of the document, never undone.
 */

import { computed, effect, signal } from '@preact/signals';
import type { PageDocument } from '../engine/types.ts';
import type { Signal } from '@preact/signals';

/** The tabs beside the page, in their order. */
export const SIDE_TABS = ['styles', 'layouts', 'words', 'page'] as const;
export type SideTab = (typeof SIDE_TABS)[number];
export type Sheet = 'photos' | 'styles' | 'layouts' | 'words' | 'settings';
type Theme = 'light' | 'dark';
export type Ui = ReturnType<typeof createUi>;

const THEME_KEY = 'inkpanel.theme';
const LETTERS_KEY = 'inkpanel.letters';
const DETECT_KEY = 'inkpanel.detect';
const IDEAS_KEY = 'inkpanel.ideas';

export type Work = 'designer' | 'explorer' | 'projects' | 'pages';

export function createUi(window: Window) {
  const wide = mediaSignal(window, '(min-width: 1000px)');
  /** Whether there is room for words where numbers do. */
  const roomy = mediaSignal(window, '(min-width: 1340px)');
  const systemDark = mediaSignal(window, '(prefers-color-scheme: dark)');
  /** The person's choice; null follows the system. */
  const theme: Signal<Theme | null> = signal(stored(window));

  effect(() => {
    const root = window.document.documentElement;
    if (theme.value) root.dataset.theme = theme.value;
    else delete root.dataset.theme;
  });

  const dark = computed(() => (theme.value ?? (systemDark.value ? 'dark' : 'light')) === 'dark');
  /** The workspace that lies over the board. */
  const work: Signal<Work | null> = signal(null);

  /** Whether single letters are shortcuts: speech input and unsteady hands set them off unasked. */
  const letterKeys = signal(remembered(window, LETTERS_KEY) !== 'off');
  /** Whether the strip of other pages is unfolded. */
  const ideas = signal(remembered(window, IDEAS_KEY) !== 'off');

  return {
    wide,
    roomy,
    letterKeys,
    useLetterKeys(on: boolean) {
      letterKeys.value = on;
      keep(window, LETTERS_KEY, on ? 'on' : 'off');
    },
    ideas,
    toggleIdeas() {
      ideas.value = !ideas.peek();
      keep(window, IDEAS_KEY, ideas.value ? 'on' : 'off');
    },
    /** Whether the page has the window to itself. */
    preview: signal(false),
    dark,
    /** The sheet that is open on a small screen. */
    sheet: signal(null) as Signal<Sheet | null>,
    /** The tab that is open beside the page on a large screen. */
    sideTab: signal('styles') as Signal<SideTab>,
    work,
    /** Opens a workspace, or closes it where it is open. */
    toggleWork(which: Work) {
      work.value = work.peek() === which ? null : which;
    },
    /** Whether photos are looked at for faces and objects; `inkpanel.detect` = `off` in the storage says no. */
    detects: remembered(window, DETECT_KEY) !== 'off',
    /** Whether the boxes of what was found are drawn. */
    subjects: signal(false),
    /** A photo of the stack that is open. */
    stack: signal(null) as Signal<string | null>,
    dialog: signal(null) as Signal<'keys' | 'export' | null>,
    /** The page that is on the screen with all its panels; null while work for it is going on. */
    painted: signal(null) as Signal<PageDocument | null>,
    /** The page whose words are all on the screen, likewise. */
    lettered: signal(null) as Signal<PageDocument | null>,
    /** What the views threw when they drew what is in the store. */
    failed: signal(null) as Signal<unknown>,
    toggleTheme() {
      theme.value = dark.peek() ? 'light' : 'dark';
      keep(window, THEME_KEY, theme.value);
    },
  };
}

function stored(window: Window): Theme | null {
  const value = remembered(window, THEME_KEY);
  return value === 'light' || value === 'dark' ? value : null;
}

function remembered(window: Window, key: string) {
  try {
    return window.localStorage.getItem(key);
  } catch {
    return null;
  }
}

function keep(window: Window, key: string, value: string) {
  try {
    window.localStorage.setItem(key, value);
  } catch {
    // Storage may be refused; the choice then lasts as long as the page.
  }
}

function mediaSignal(window: Window, query: string) {
  const list = window.matchMedia(query);
  const value = signal(list.matches);
  list.addEventListener('change', () => {
    value.value = list.matches;
  });
  return value;
}
