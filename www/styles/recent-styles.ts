/** Recently used styles on this device, the first in the list of styles. */

import { signal } from '@preact/signals';

type Box = Pick<Storage, 'getItem' | 'setItem'>;
export type RecentStyles = ReturnType<typeof createRecentStyles>;

const KEY = 'inkpanel.recent-styles';
const MOST = 6;

/** @param box may throw if storage is blocked: then the list lasts until the page closes */
export function createRecentStyles(box: () => Box) {
  const ids = signal(read(box));
  return {
    /** The last one first. */
    ids,
    /** Puts a style first. */
    add(id: string) {
      ids.value = [id, ...ids.peek().filter((other) => other !== id)].slice(0, MOST);
      try {
        box().setItem(KEY, JSON.stringify(ids.peek()));
      } catch {
        // Storage is blocked or full. The choices of this visit are still in memory.
      }
    },
  };
}

function read(box: () => Box): readonly string[] {
  try {
    const ids: unknown = JSON.parse(box().getItem(KEY) ?? '[]');
    return Array.isArray(ids) ? ids.filter((id) => typeof id === 'string').slice(0, MOST) : [];
  } catch {
    return [];
  }
}
