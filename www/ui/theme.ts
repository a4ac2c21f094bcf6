/**
 * Light or dark theme: the user's choice, or the current system setting. `public/theme.js` has laid the choice on the
 * document before the first paint.
 */

import { computed, effect, signal } from '@preact/signals';
import { mediaSignal } from './media.ts';
import type { Signal } from '@preact/signals';

/** In the order in which they are offered. */
export const THEMES = ['light', 'dark', 'system'] as const;
export type Theme = (typeof THEMES)[number];

const KEY = 'inkpanel.theme';

export function createTheme(window: Window) {
  const systemDark = mediaSignal(window, '(prefers-color-scheme: dark)');
  const theme: Signal<Theme> = signal(stored(window));

  effect(() => {
    const root = window.document.documentElement;
    if (theme.value === 'system') delete root.dataset.theme;
    else root.dataset.theme = theme.value;
    colourBrowser(window.document, theme.value);
  });

  return {
    theme,
    dark: computed(() => (theme.value === 'system' ? systemDark.value : theme.value === 'dark')),
    useTheme(chosen: Theme) {
      theme.value = chosen;
      try {
        if (chosen === 'system') window.localStorage.removeItem(KEY);
        else window.localStorage.setItem(KEY, chosen);
      } catch {
        // Storage may be refused; the choice then lasts as long as the page.
      }
    },
  };
}

function stored(window: Window): Theme {
  try {
    const value = window.localStorage.getItem(KEY);
    return value === 'light' || value === 'dark' ? value : 'system';
  } catch {
    return 'system';
  }
}

/** The browser's own bars, which a phone has above the page: each colour is for the system's theme unless one is chosen. */
function colourBrowser(document: Document, theme: Theme) {
  for (const meta of document.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]')) {
    const own = (meta.dataset.theme ??= meta.media.includes('dark') ? 'dark' : 'light');
    meta.media = theme === 'system' ? `(prefers-color-scheme: ${own})` : theme === own ? 'all' : 'not all';
  }
}
