import { signal } from '@preact/signals';
import type { Signal } from '@preact/signals';

/** @returns whether a media query matches, as a signal */
export function mediaSignal(window: Window, query: string): Signal<boolean> {
  const list = window.matchMedia(query);
  const value = signal(list.matches);
  list.addEventListener('change', () => {
    value.value = list.matches;
  });
  return value;
}

/** Returns whether the device is a phone in any orientation. Few phones have spare memory. */
export function isHandheld(window: Pick<Window, 'matchMedia' | 'screen'>): boolean {
  return window.matchMedia('(pointer: coarse)').matches && Math.min(window.screen.width, window.screen.height) < 600;
}
