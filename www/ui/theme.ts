/**
 * Light or dark: what the person chose, else what the system wants, as it changes. `public/theme.js` has laid the choice on the
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
