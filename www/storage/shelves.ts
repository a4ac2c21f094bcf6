/**
 * Custom styles, favourites and custom layouts in this browser's storage. All projects and tabs share them. Only
 * changes are written, so tabs do not revert each other.
 */

import { effect, untracked } from '@preact/signals';
import { MOST } from '../document/limits.ts';
import { SHARED } from '../document/project.ts';
import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { SharedLists } from '../document/project.ts';
import type { Style, Template } from '../engine/types.ts';
import type { Store } from '../document/store.ts';

type Box = Pick<Storage, 'getItem' | 'setItem'>;
/** How the core reads what is in each list. */
type Checks = { [Field in keyof SharedLists]: (json: string, file: string) => SharedLists[Field][number] };
export type Shelves = ReturnType<typeof createShelves>;

const KEYS: Record<keyof SharedLists, string> = {
  mine: 'inkpanel.styles',
  favourites: 'inkpanel.favourites',
  ownLayouts: 'inkpanel.layouts',
};

/** `box` may throw if storage is blocked */
export function createShelves({
  store,
  messages,
  box,
}: {
  store: Store;
  messages: Pick<Messages, 'grave'>;
  box: () => Box;
}) {
  /** The stored lists; nothing is written before they were read. */
  let kept: SharedLists | null = null;
  /** The lists that were dealt with last. */
  let seen: Partial<SharedLists> = {};

  // Undo changes the stored lists as well.
  effect(() => {
    const project = store.project.value;
    untracked(() => SHARED.forEach((field) => write(field, project[field])));
  });

  return { recall, restore, hear, lists };

  /** Writes lists again that are missing from storage. The app never removes lists; empty ones are stored as well. */
  function restore() {
    for (const field of SHARED)
      if (kept !== null && kept[field].length > 0 && isGone(field)) write(field, store.project.peek()[field], true);
  }

  /** Reads the stored lists. Damaged lists are ignored without a message. */
  function recall() {
    restore();
    const now = { mine: read('mine'), favourites: read('favourites'), ownLayouts: read('ownLayouts') };
    const here = store.project.peek();
    // Unsaved local changes stay.
    const next = kept && {
      mine: carried(here.mine, kept.mine, now.mine),
      favourites: carried(here.favourites, kept.favourites, now.favourites),
      ownLayouts: carried(here.ownLayouts, kept.ownLayouts, now.ownLayouts),
    };
    kept = now;
    store.change({ type: 'share', lists: next ?? now });
  }

  /** Another tab has written, or thrown all away. */
  function hear({ key }: { key: string | null }) {
    if (kept !== null && (key === null || SHARED.some((field) => KEYS[field] === key))) recall();
  }

  /** @returns applies the changes between two states of a list to another state */
  function carried<Item>(list: readonly Item[], before: readonly Item[], after: readonly Item[]): readonly Item[] {
    return store.planner.peek()?.carried(list, before, after) ?? after;
  }

  /** @returns the lists of all projects */
  function lists(): Partial<SharedLists> {
    const { mine, favourites, ownLayouts } = store.project.peek();
    return kept === null ? {} : { mine, favourites, ownLayouts };
  }

  /** @param gone whether storage lost the list */
  function write(field: keyof SharedLists, list: readonly (Style | Template)[], gone: boolean = false) {
    if (kept === null || (list === seen[field] && !gone)) return;
    seen = { ...seen, [field]: list };
    if (JSON.stringify(list) === JSON.stringify(kept[field]) && !gone) return;
    try {
      const merged = gone || isGone(field) ? list : carried<Style | Template>(read(field), kept[field], list);
      box().setItem(KEYS[field], JSON.stringify(merged));
      kept = { ...kept, [field]: list };
    } catch {
      messages.grave(strings.stylesNotKept);
    }
  }

  function isGone(field: keyof SharedLists) {
    try {
      return box().getItem(KEYS[field]) === null;
    } catch {
      return false;
    }
  }

  function read<Field extends keyof SharedLists>(field: Field): readonly SharedLists[Field][number][] {
    const planner = store.planner.peek();
    if (!planner) return [];
    const { checkStyle, checkLayout } = planner;
    const checks: Checks = { mine: checkStyle, favourites: checkStyle, ownLayouts: checkLayout };
    try {
      const found = JSON.parse(box().getItem(KEYS[field]) ?? '[]');
      return (Array.isArray(found) ? found : []).slice(0, MOST.styles).flatMap((item) => {
        try {
          return [checks[field](JSON.stringify(item), KEYS[field])];
        } catch {
          return [];
        }
      });
    } catch {
      return [];
    }
  }
}
