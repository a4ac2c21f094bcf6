import { signal } from '@preact/signals';
import type { Signal } from '@preact/signals';

/** @returns whether a media query holds, as it changes */
export function mediaSignal(window: Window, query: string): Signal<boolean> {
  const list = window.matchMedia(query);
  const value = signal(list.matches);
  list.addEventListener('change', () => {
    value.value = list.matches;
  });
  return value;
}
