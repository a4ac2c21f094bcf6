// @ts-check
/**
 * A person's own styles, favourites and layouts in this browser's storage. All projects and all tabs share them: what
 * is written is what was changed, so that no tab takes back what another did.
 */

import { effect, untracked } from '@preact/signals';
import { MOST } from '../limits.js';
import { SHARED, carried } from '../shared-lists.js';
import { strings } from '../../strings.js';

/** @typedef {Pick<Storage, 'getItem' | 'setItem'>} Box */
/** @typedef {import('../shared-lists.js').SharedLists} SharedLists */
/** @typedef {ReturnType<typeof createShelves>} Shelves */

/** @type {Record<keyof SharedLists, string>} */
const KEYS = { mine: 'inkpanel.styles', favourites: 'inkpanel.favourites', ownLayouts: 'inkpanel.layouts' };

/**
 * @param {{
 *   store: import('../store.js').Store, messages: Pick<import('../messages.js').Messages, 'grave'>, box: () => Box,
 * }} app `box` may throw where storage is refused
 */
export function createShelves({ store, messages, box }) {
  /** What is known to be kept; nothing is written before it was read. @type {SharedLists | null} */
  let kept = null;
  /** The lists that were dealt with last. @type {Partial<SharedLists>} */
  let seen = {};

  // Undo, too, changes what is kept.
  effect(() => {
    const project = store.project.value;
    untracked(() => SHARED.forEach((field) => write(field, project[field])));
  });

  return { recall, restore, hear, lists };

  /** Writes again what is there no more: nobody takes a list away, an empty one is written too. */
  function restore() {
    for (const field of SHARED) if (kept !== null && kept[field].length > 0 && isGone(field)) write(field, store.project.peek()[field], true);
  }

  /** Reads what is kept. One that can no longer be read is left out; it is said nowhere, as nobody asked. */
  function recall() {
    restore();
    const now = { mine: read('mine'), favourites: read('favourites'), ownLayouts: read('ownLayouts') };
    const here = store.project.peek();
    // What could not be written here stays.
    const next = kept === null ? now : Object.fromEntries(SHARED.map((field) => (
      [field, carried(/** @type {any} */ (here[field]), /** @type {SharedLists} */ (kept)[field], now[field])]
    )));
    kept = now;
    store.change({ type: 'share', lists: next });
  }

  /** Another tab has written, or thrown all away. @param {{ key: string | null }} event */
  function hear({ key }) {
    if (kept !== null && (key === null || SHARED.some((field) => KEYS[field] === key))) recall();
  }

  /** @returns {Partial<SharedLists>} what all projects have in common */
  function lists() {
    const { mine, favourites, ownLayouts } = store.project.peek();
    return kept === null ? {} : { mine, favourites, ownLayouts };
  }

  /** @param {keyof SharedLists} field @param {readonly any[]} list @param {boolean} [gone] nothing of it is kept any more */
  function write(field, list, gone = false) {
    if (kept === null || (list === seen[field] && !gone)) return;
    seen = { ...seen, [field]: list };
    if (JSON.stringify(list) === JSON.stringify(kept[field]) && !gone) return;
    try {
      const merged = gone || isGone(field) ? list : carried(/** @type {any[]} */ (read(field)), kept[field], list);
      box().setItem(KEYS[field], JSON.stringify(merged));
      kept = { ...kept, [field]: list };
    } catch {
      messages.grave(strings.stylesNotKept);
    }
  }

  /** @param {keyof SharedLists} field */
  function isGone(field) {
    try {
      return box().getItem(KEYS[field]) === null;
    } catch {
      return false;
    }
  }

  /** @param {keyof SharedLists} field @returns {any[]} */
  function read(field) {
    const planner = store.planner.peek();
    if (!planner) return [];
    const check = field === 'ownLayouts' ? planner.checkLayout : planner.checkStyle;
    try {
      const found = JSON.parse(box().getItem(KEYS[field]) ?? '[]');
      return (Array.isArray(found) ? found : []).slice(0, MOST.styles).flatMap((item) => {
        try {
          return [check(JSON.stringify(item), KEYS[field])];
        } catch {
          return [];
        }
      });
    } catch {
      return [];
    }
  }
}
