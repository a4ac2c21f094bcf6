// @ts-check
/**
 * Words as pages are planned: the letters, loaded when a page first has words, and the places of those that nobody has
 * moved.
 */

import { computed, effect, signal } from '@preact/signals';
import { strings } from '../strings.js';

/** @typedef {import('../engine/core.js').Planner} Planner */
/** @typedef {import('../engine/words.js').Lettering} Letters */
/** @typedef {import('../engine/documents.js').Word} Word */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */

/** Words are shown among the alternatives once a drag rests for this long, in ms. */
const REST = 300;

/**
 * @param {{
 *   store: import('./store.js').Store, messages: Pick<import('./messages.js').Messages, 'alert'>, load: () => Promise<Letters>,
 * }} app `load`: what knows the letters
 */
export function createWordPlanning({ store, messages, load }) {
  /** @type {import('@preact/signals').Signal<Letters | null>} */
  const letters = signal(null);
  const none = /** @type {readonly Word[]} */ ([]);
  const words = computed(() => store.page.value?.words ?? none);
  /** The words as they were when they last rested. */
  const rested = signal(none);

  /** @type {any} */
  let timer;
  effect(() => {
    const now = words.value;
    clearTimeout(timer);
    if (essence(now) !== essence(rested.peek())) timer = setTimeout(() => { rested.value = now; }, REST);
  });
  // A page that comes with words, from a file or a session before, needs the letters too.
  effect(() => {
    if (words.value.length > 0 && !letters.value) ready().then(() => settle(true), failed);
  });

  return { words, letters, rested, ready, failed, within, settled, on };

  async function ready() {
    letters.value ??= await load();
  }

  /** @param {Error} error */
  function failed(error) {
    messages.alert(strings.wordsFailed(error.message));
  }

  /**
   * A planner whose pages have their words where they hide no face.
   * @param {Planner} planner
   * @returns {Planner}
   */
  function within(planner) {
    return { ...planner, plan: (request) => settled(planner.plan(request)) };
  }

  /**
   * @param {PageDocument} page
   * @param {readonly number[]} [only] the words that may move; all unless told
   * @returns {PageDocument}
   */
  function settled(page, only) {
    const table = letters.peek();
    const all = page.words ?? [];
    const stays = (/** @type {number} */ i) => only !== undefined && !only.includes(i);
    if (!table || !all.some(({ auto }, i) => auto !== false && !stays(i))) return page;
    const album = store.album.peek();
    const subjects = Object.fromEntries(page.panels.flatMap(({ photo }) => {
      const meta = photo === null ? undefined : album.get(photo)?.meta;
      return meta ? [[photo, meta.subjects]] : [];
    }));
    const fixed = all.map((word, i) => (stays(i) ? { ...word, auto: false } : word));
    const placed = table.settle({ ...page, words: fixed }, subjects);
    return { ...page, words: all.map((word, i) => (stays(i) ? word : placed[i])) };
  }

  /**
   * Another page with the words of this one.
   * @param {PageDocument} page
   * @returns {PageDocument}
   */
  function on(page) {
    return !page.words?.length && words.peek().length === 0 ? page : settled({ ...page, words: [...words.peek()] });
  }

  /** @param {boolean} silent */
  function settle(silent) {
    const page = store.page.peek();
    const next = page && settled(page);
    if (next && JSON.stringify(next.words) !== JSON.stringify(page.words)) store.change({ type: 'change-page', page: next, silent });
  }
}

/** @param {readonly Word[]} words @returns {string} all but the places that the core chooses */
function essence(words) {
  return JSON.stringify(words.map((word) => (word.auto ? { ...word, x: 0, y: 0, tail: null } : word)));
}
