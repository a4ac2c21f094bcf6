// @ts-check
/**
 * What the window looks like: never part of the document, never undone.
 */

import { effect, signal } from '@preact/signals';

/** @typedef {'photos' | 'styles' | 'layouts' | 'words' | 'settings'} Sheet */
/** @typedef {'light' | 'dark'} Theme */
/** @typedef {ReturnType<typeof createUi>} Ui */

const THEME_KEY = 'inkpanel.theme';
const LETTERS_KEY = 'inkpanel.letters';
const DETECT_KEY = 'inkpanel.detect';

/** @param {Window} window */
export function createUi(window) {
  const wide = mediaSignal(window, '(min-width: 1000px)');
  const systemDark = mediaSignal(window, '(prefers-color-scheme: dark)');
  /** The person's choice; null follows the system. @type {import('@preact/signals').Signal<Theme | null>} */
  const theme = signal(stored(window));

  effect(() => {
    const root = window.document.documentElement;
    if (theme.value) root.dataset.theme = theme.value;
    else delete root.dataset.theme;
  });

  /** Whether single letters are shortcuts: speech input and unsteady hands set them off unasked. */
  const letterKeys = signal(remembered(window, LETTERS_KEY) !== 'off');

  return {
    wide,
    letterKeys,
    /** @param {boolean} on */
    useLetterKeys(on) {
      letterKeys.value = on;
      keep(window, LETTERS_KEY, on ? 'on' : 'off');
    },
    theme,
    systemDark,
    /** The sheet that is open on a small screen. @type {import('@preact/signals').Signal<Sheet | null>} */
    sheet: signal(null),
    /** The workspace that lies over the board. @type {import('@preact/signals').Signal<'designer' | 'explorer' | 'projects' | 'pages' | null>} */
    work: signal(null),
    /** Whether photos are looked at for faces and objects; `inkpanel.detect` = `off` in the storage says no. */
    detects: remembered(window, DETECT_KEY) !== 'off',
    /** Whether the boxes of what was found are drawn. */
    subjects: signal(false),
    /** A photo of the stack that is open. @type {import('@preact/signals').Signal<string | null>} */
    stack: signal(null),
    /** @type {import('@preact/signals').Signal<'keys' | 'export' | null>} */
    dialog: signal(null),
    /** The page that is on the screen with all its panels; null while work for it is going on.
     * @type {import('@preact/signals').Signal<import('../engine/documents.js').PageDocument | null>} */
    painted: signal(null),
    /** The page whose words are all on the screen, likewise.
     * @type {import('@preact/signals').Signal<import('../engine/documents.js').PageDocument | null>} */
    lettered: signal(null),
    /** What the views threw when they drew what is in the store. @type {import('@preact/signals').Signal<unknown>} */
    failed: signal(null),
    toggleTheme() {
      const dark = (theme.value ?? (systemDark.value ? 'dark' : 'light')) === 'dark';
      theme.value = dark ? 'light' : 'dark';
      keep(window, THEME_KEY, theme.value);
    },
  };
}

/**
 * @param {Window} window
 * @returns {Theme | null}
 */
function stored(window) {
  const value = remembered(window, THEME_KEY);
  return value === 'light' || value === 'dark' ? value : null;
}

/**
 * @param {Window} window
 * @param {string} key
 */
function remembered(window, key) {
  try {
    return window.localStorage.getItem(key);
  } catch {
    return null;
  }
}

/**
 * @param {Window} window
 * @param {string} key
 * @param {string} value
 */
function keep(window, key, value) {
  try {
    window.localStorage.setItem(key, value);
  } catch {
    // Storage may be refused; the choice then lasts as long as the page.
  }
}

/**
 * @param {Window} window
 * @param {string} query
 */
function mediaSignal(window, query) {
  const list = window.matchMedia(query);
  const value = signal(list.matches);
  list.addEventListener('change', () => {
    value.value = list.matches;
  });
  return value;
}
