/** Switches that the browser remembers. If it denies storage, a choice lasts until the app is closed. */

import { signal } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';

export type RememberedSwitch = { on: ReadonlySignal<boolean>; turn: (on: boolean) => void };

/**
 * @param box may throw
 * @param usual the value before the first choice
 */
export function rememberedSwitch(
  box: () => Pick<Storage, 'getItem' | 'setItem'>,
  key: string,
  usual: boolean,
): RememberedSwitch {
  const stored = remembered(box, key);
  const on = signal(stored === null ? usual : stored === 'on');
  return {
    on,
    turn(next) {
      on.value = next;
      remember(box, key, next ? 'on' : 'off');
    },
  };
}

/** @returns the stored text, or null */
export function remembered(box: () => Pick<Storage, 'getItem'>, key: string) {
  try {
    return box().getItem(key);
  } catch {
    return null;
  }
}

export function remember(box: () => Pick<Storage, 'setItem'>, key: string, value: string) {
  try {
    box().setItem(key, value);
  } catch {
    // Storage is blocked or full.
  }
}
