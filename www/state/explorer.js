// @ts-check
/**
 * The explorer: styles invented from seeds, or bred from others, tried out on the person's photo as they come. What
 * looks like another, or like nothing, is left out. The wall belongs to the session; favourites are kept.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings.js';
import { createScores } from './explorer-scores.js';
import { createWall } from './explorer-wall.js';

/** @typedef {import('../engine/documents.js').Style} Style */
/** @typedef {import('./explorer-wall.js').Item} Item */
/** @typedef {{ id: string, width: number, height: number }} Photo what the styles are tried on, and how large */
/** @typedef {ReturnType<typeof createExplorer>} Explorer */

/** Styles that one press invents. */
export const ROUND = 240;
/** Children of two styles, and variations of one. */
const LITTER = 12;
/** Styles sent to a worker at a time, and how many such parcels are on their way: no worker waits for the next. */
const PARCEL = 6;
const AHEAD = 4;

/**
 * @param {{
 *   store: import('./store.js').Store, engine: Pick<import('../engine/engine.js').Engine, 'exploreStyles' | 'judges' | 'judgeStyle' | 'hasPhoto'>,
 *   messages: import('./messages.js').Messages, ownStyles: Pick<import('./own-styles.js').OwnStyles, 'favourites' | 'isFavourite'>,
 *   seed: () => number, judged?: boolean,
 * }} app not `judged`, styles are sorted by the light score alone
 */
export function createExplorer({ store, engine, messages, ownStyles, seed, judged = true }) {
  const wall = createWall(ownStyles.isFavourite);
  /** @type {import('@preact/signals').Signal<import('./store.js').Progress | null>} */
  const progress = signal(null);
  const sorted = signal(false);
  const scores = createScores({ engine, messages, items: wall.items, sorted, wanted: judged });
  const look = signal('all');
  const surprise = signal(0.35);
  /** The style that waits for another to breed with. @type {import('@preact/signals').Signal<Style | null>} */
  const parent = signal(null);
  const first = signal(seed());
  let made = 0;
  /** @type {AbortController | null} */
  let running = null;

  const shown = computed(() => {
    const kind = look.value;
    const list = wall.items.value.filter(({ style, look: own }) => (
      kind === 'all' || own === kind || (kind === 'favourites' && ownStyles.isFavourite(style.id))
    ));
    return sorted.value ? list.sort((a, b) => scores.rank(b) - scores.rank(a)) : list;
  });

  return {
    items: wall.items, dropped: wall.dropped, pictures: wall.pictures,
    shown, progress, sorted, scores, look, surprise, parent, first, generate, stop, clear, begin, breed, moreLike, showFavourites,
  };

  /** Invents another round. @param {Photo} photo */
  function generate(photo) {
    const planner = store.planner.peek();
    if (!planner) return Promise.resolve();
    const from = first.peek() + made;
    made += ROUND;
    // Made as they are needed: a round that is stopped early costs no more.
    return run(photo, ROUND, (i) => planner.inventStyle((from + i) >>> 0), true);
  }

  /** Begins with another seed. @param {number} value */
  function begin(value) {
    first.value = value >>> 0;
    made = 0;
  }

  /**
   * Chooses a parent, or, where one is chosen, breeds the two.
   * @param {Style} style
   * @param {Photo} photo
   */
  async function breed(style, photo) {
    const other = parent.peek();
    parent.value = other ? null : style;
    if (other && other.id !== style.id) await litter(other, style, surprise.peek(), photo);
  }

  /** @param {Style} style @param {Photo} photo */
  async function moreLike(style, photo) {
    await litter(style, style, Math.max(0.15, surprise.peek()), photo);
  }

  /**
   * @param {Style} a
   * @param {Style} b
   * @param {number} wild
   * @param {Photo} photo
   */
  async function litter(a, b, wild, photo) {
    const planner = store.planner.peek();
    if (!planner) return;
    const from = seed();
    await run(photo, LITTER, (i) => planner.breedStyle({ a, b, seed: (from + i) >>> 0, surprise: wild }), true, true);
  }

  /** Puts the favourites on the wall that are not there. @param {Photo} photo */
  async function showFavourites(photo) {
    const missing = ownStyles.favourites.peek().filter(({ id }) => !wall.pictures.has(id));
    if (missing.length > 0) await run(photo, missing.length, (i) => missing[i], false);
  }

  /**
   * @param {Photo} photo
   * @param {number} count
   * @param {(i: number) => Style} make
   * @param {boolean} choosy whether what is alike or empty is left out
   * @param {boolean} [ahead] whether they go before all others
   */
  async function run(photo, count, make, choosy, ahead = false) {
    stop();
    const mine = new AbortController();
    running = mine;
    progress.value = { done: 0, total: count };
    let next = 0;
    let done = 0;
    const work = async () => {
      while (next < count && !mine.signal.aborted) {
        const styles = Array.from({ length: Math.min(PARCEL, count - next) }, (_, i) => make(next + i));
        next += styles.length;
        const explored = await engine.exploreStyles(photo.id, styles, photo, { signal: mine.signal });
        if (mine.signal.aborted) return;
        done += styles.length;
        wall.hang(photo, styles, explored, choosy, ahead);
        progress.value = { done, total: count };
      }
    };
    try {
      await Promise.all(Array.from({ length: AHEAD }, work));
    } catch (error) {
      const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
      if (code !== 'cancelled') messages.alert(strings.explorerFailed(message));
      mine.abort();
    }
    if (running === mine) {
      running = null;
      progress.value = null;
    }
  }

  function stop() {
    running?.abort();
    running = null;
    progress.value = null;
  }

  function clear() {
    stop();
    parent.value = null;
    scores.forget();
    wall.clear();
  }
}
