/**
 * The explorer: styles invented from seeds, or bred from others, tried out on the person's photo as they come. What
 * looks like another, or like nothing, is left out. The wall belongs to the session; favourites are kept.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { createScores } from './explorer-scores.ts';
import { createWall } from './explorer-wall.ts';
import type { Messages } from '../ui/messages.ts';
import type { Progress, Store } from '../document/store.ts';
import type { Style } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { OwnStyles } from '../styles/own-styles.ts';
import type { Item } from './explorer-wall.ts';
import type { Signal } from '@preact/signals';

export type { Item };
/** The names of the styles that one was bred from, the same twice where it is more like one; a litter shares it. */
export type Parents = readonly [string, string];
/** what the styles are tried on, and how large */
export type Photo = { id: string; width: number; height: number };
export type Explorer = ReturnType<typeof createExplorer>;

/** Styles that one press invents. */
export const ROUND = 240;
/** Children of two styles, and variations of one. */
const LITTER = 12;
/** Styles sent to a worker at a time, and how many such parcels are on their way: no worker waits for the next. */
const PARCEL = 6;
const AHEAD = 4;

/** @param app not `judged`, styles are sorted by the light score alone */
export function createExplorer({
  store,
  engine,
  messages,
  ownStyles,
  seed,
  judged = true,
}: {
  store: Store;
  engine: Pick<Engine, 'exploreStyles' | 'judges' | 'judgeStyle' | 'hasPhoto'>;
  messages: Messages;
  ownStyles: Pick<OwnStyles, 'favourites' | 'isFavourite'>;
  seed: () => number;
  judged?: boolean;
}) {
  const wall = createWall(ownStyles.isFavourite);
  const progress: Signal<Progress | null> = signal(null);
  const sorted = signal(false);
  const scores = createScores({ engine, messages, items: wall.items, sorted, wanted: judged });
  const look = signal('all');
  const surprise = signal(0.35);
  /** The style that waits for another to breed with. */
  const parent: Signal<Style | null> = signal(null);
  const first = signal(seed());
  /** What bred styles come from. */
  const parents: Map<string, Parents> = new Map();
  /** The parents of the last litter. */
  const lastParents: Signal<Parents | null> = signal(null);
  let made = 0;
  let running: AbortController | null = null;

  const shown = computed(() => {
    const kind = look.value;
    const list = wall.items.value.filter(
      ({ style, look: own }) =>
        kind === 'all' || own === kind || (kind === 'favourites' && ownStyles.isFavourite(style.id)),
    );
    return sorted.value ? list.sort((a, b) => scores.rank(b) - scores.rank(a)) : list;
  });

  return {
    items: wall.items,
    dropped: wall.dropped,
    pictures: wall.pictures,
    shown,
    progress,
    sorted,
    scores,
    look,
    surprise,
    parent,
    lastParents,
    parentsOf: (id: string) => parents.get(id),
    first,
    generate,
    stop,
    clear,
    begin,
    breed,
    moreLike,
    showFavourites,
  };

  /** Invents another round. */
  function generate(photo: Photo) {
    const planner = store.planner.peek();
    if (!planner) return Promise.resolve();
    const from = first.peek() + made;
    made += ROUND;
    // Made as they are needed: a round that is stopped early costs no more.
    return run(photo, ROUND, (i) => planner.inventStyle((from + i) >>> 0), true);
  }

  /** Begins with another seed. */
  function begin(value: number) {
    first.value = value >>> 0;
    made = 0;
  }

  /** Chooses a parent, or, where one is chosen, breeds the two. */
  async function breed(style: Style, photo: Photo) {
    const other = parent.peek();
    parent.value = other ? null : style;
    if (other && other.id !== style.id) await litter(other, style, surprise.peek(), photo);
  }

  async function moreLike(style: Style, photo: Photo) {
    await litter(style, style, Math.max(0.15, surprise.peek()), photo);
  }

  async function litter(a: Style, b: Style, wild: number, photo: Photo) {
    const planner = store.planner.peek();
    if (!planner) return;
    const from = seed();
    const names: Parents = [a.name, b.name];
    lastParents.value = names;
    const child = (i: number) => {
      const style = planner.breedStyle({ a, b, seed: (from + i) >>> 0, surprise: wild });
      parents.set(style.id, names);
      return style;
    };
    await run(photo, LITTER, child, true, true);
  }

  /** Puts the favourites on the wall that are not there. */
  async function showFavourites(photo: Photo) {
    const missing = ownStyles.favourites.peek().filter(({ id }) => !wall.pictures.has(id));
    if (missing.length > 0) await run(photo, missing.length, (i) => missing[i], false);
  }

  /**
   * @param choosy whether what is alike or empty is left out
   * @param ahead whether they go before all others
   */
  async function run(photo: Photo, count: number, make: (i: number) => Style, choosy: boolean, ahead: boolean = false) {
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
      const { code, message } = error as { code?: string; message: string };
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
    parents.clear();
    lastParents.value = null;
    scores.forget();
    wall.clear();
  }
}
