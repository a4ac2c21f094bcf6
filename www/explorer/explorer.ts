/**
 * The explorer: styles generated from seeds, or combined from others, shown on the user's photo as they arrive. Styles
 * whose image is similar to another one, or almost empty, are rejected. The wall belongs to the session; favourites are
 * saved.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { coloured } from './colouring.ts';
import { createScores } from './explorer-scores.ts';
import { createWall } from './explorer-wall.ts';
import { damageOf, isClipped } from './damage.ts';
import { PLAIN } from '../photos/cover.ts';
import { codeOf, explain } from '../ui/explain.ts';
import type { Messages } from '../ui/messages.ts';
import type { Progress, Store } from '../document/store.ts';
import type { Explored } from '../engine/protocol.ts';
import type { Style } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { OwnStyles } from '../styles/own-styles.ts';
import type { Hue, Lightness } from './colours.ts';
import type { Item } from './explorer-wall.ts';
import type { Signal } from '@preact/signals';

export type { Item };
type Parent = Pick<Style, 'id' | 'name'>;
/** Parents of a combined style. A variation has one parent twice. Styles of one run share them. */
export type Parents = readonly [Parent, Parent];
/** the photo of the wall, and its size */
export type Photo = { id: string; width: number; height: number };
/** The current task: `redraw` draws the wall with another photo. */
export type Doing = Progress & { what: 'invent' | 'redraw' };
/** Styles of all rounds of one press. */
type Rounds = { tried: number; added: number };
export type Explorer = ReturnType<typeof createExplorer>;

/** Styles that the wall opens with, and that one press invents. For some photos only few styles are good, so more are tried. */
export const FIRST = 96;
const FIRST_TRIES = 10 * FIRST;
/** Styles of the first wall that are sorted and shown together. Later ones never move them. */
export const TOGETHER = 24;
/** Points that neon colours or bleached areas everywhere cost on the first wall. */
const HARSH = 100;
export const ROUND = 240;
/** Number of styles that one press tries to add in at most this many rounds. */
export const FAIR = 48;
const MAX_ROUNDS = 4;
/** Number of styles of a round below which another round is not worth its time. */
const HOPELESS = 12;
/** Number of children of two styles, and of variations of one style. `TRIES` limits the attempts. */
export const LITTER = 12;
const TRIES = 48;
/** Styles per message to a worker, and number of pending messages, so that no worker is idle. */
const PARCEL = 6;
const AHEAD = 4;

/** @param app `judged`: without it, the model is not used */
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
  /** Measurements of photos without a style. */
  const plain: Map<string, Pick<Explored, 'signature' | 'clipped'>> = new Map();
  const wall = createWall(ownStyles.isFavourite, (photo, picture) => {
    const meta = store.album.peek().get(photo)?.meta;
    const before = plain.get(photo);
    return (
      isClipped(picture, before?.clipped) || (!!meta && damageOf(meta, picture.signature, before?.signature) !== '')
    );
  });
  const progress: Signal<Doing | null> = signal(null);
  const scores = createScores({ engine, messages, items: wall.items, wanted: judged, complete: finishSort });
  const look = signal('all');
  const hue: Signal<Hue | null> = signal(null);
  const lightness: Signal<Lightness | null> = signal(null);
  /** The favourites at the time of the last request. A removed favourite keeps its place until the next one. */
  const wasFavourite: Signal<ReadonlySet<string>> = signal(new Set());
  const surprise = signal(0.35);
  /** The style that waits for another to breed with. */
  const parent: Signal<Style | null> = signal(null);
  const first = signal(seed());
  /** Parents of combined styles. */
  const parents: Map<string, Parents> = new Map();
  /** The parents of the last litter, whose children are shown whatever the wall is filtered by. */
  const lastParents: Signal<Parents | null> = signal(null);
  /** Whether the user has sorted the wall. */
  const sorted = signal(false);
  /** Whether the last sort is repeated when the model has scored the styles. */
  let isSorting = false;
  const begun: Signal<string | null> = signal(null);
  let made = 0;
  let running: AbortController | null = null;
  /** Styles that will be shown together with the next ones. */
  let waiting: Item[] = [];

  const shown = computed(() => {
    const [kind, litter] = [look.value, lastParents.value];
    const wanted = (item: Item) =>
      (kind === 'all' || item.look === kind || (kind === 'favourites' && favoured(item.style.id))) &&
      (hue.value === null || item.hue === hue.value) &&
      (lightness.value === null || item.lightness === lightness.value);
    return wall.items.value.filter(
      (item) => wanted(item) || (litter !== null && parents.get(item.style.id) === litter),
    );
  });
  /** Whether new styles or scores have made the order outdated. */
  const unsorted = computed(
    () => sorted.value && shown.value.some((item, i, all) => i > 0 && scores.points(item) > scores.points(all[i - 1])),
  );

  return {
    items: wall.items,
    dropped: wall.dropped,
    pictures: wall.pictures,
    shown,
    progress,
    unsorted,
    scores,
    look: computed(() => look.value),
    hue,
    lightness,
    surprise,
    parent,
    lastParents,
    parentsOf: (id: string) => parents.get(id),
    first,
    /** The photo of the first wall. The wall stays on it if another photo becomes the photo of all thumbnails. */
    begun: computed(() => begun.value),
    /** The photo that was chosen for the wall. */
    photo: signal(null) as Signal<string | null>,
    /** The style that is seen large. */
    enlarged: signal(null) as Signal<string | null>,
    open,
    generate,
    sort,
    filter,
    stop,
    clear,
    begin,
    breed,
    moreLike,
  };

  function favoured(id: string) {
    return ownStyles.isFavourite(id) || wasFavourite.value.has(id);
  }

  /** @param kind of look, `all` or `favourites` */
  function filter(kind: string) {
    look.value = kind;
    lastParents.value = null;
    wasFavourite.value = new Set(ownStyles.favourites.peek().map(({ id }) => id));
  }

  /**
   * Shows the wall on this photo: favourites first, then existing styles. An empty wall gets a first round of styles.
   */
  async function open(photo: Photo) {
    begun.value ??= photo.id;
    const missing = ownStyles.favourites.peek().filter(({ id }) => !wall.pictures.has(id));
    if (missing.length > 0 && !(await run(photo, missing.length, (i) => missing[i], { choosy: false }))) return;
    if (!(await redraw(photo))) return;
    if (!wall.items.peek().every(({ style }) => ownStyles.isFavourite(style.id))) return;
    await invent(photo, FIRST_TRIES, { enough: FIRST, together: TOGETHER });
  }

  /** Invents another round, and more rounds if few styles are good. Whole rounds keep the seeds of the next ones. */
  async function generate(photo: Photo) {
    if (!(await redraw(photo))) return;
    const rounds: Rounds = { tried: 0, added: 0 };
    let before = -Infinity;
    while (rounds.tried < MAX_ROUNDS * ROUND && rounds.added < FAIR && rounds.added - before >= HOPELESS) {
      before = rounds.added;
      if (!(await invent(photo, ROUND, { rounds }))) break;
    }
    if (running === null) progress.value = null;
  }

  /** @param how `enough`: number of styles to add (default: all); `together`: number of styles that are shown at once */
  function invent(photo: Photo, count: number, how: { enough?: number; together?: number; rounds?: Rounds } = {}) {
    const planner = store.planner.peek();
    if (!planner) return Promise.resolve(false);
    const from = first.peek() + made;
    const blocks = planner.blocks();
    made += count;
    // Generated on demand, so that cancelling early costs nothing.
    const make = (i: number) => {
      const at = (from + i) >>> 0;
      return coloured(planner.inventStyle(at), at, blocks);
    };
    return run(photo, count, make, { choosy: true, ...how });
  }

  /** Begins with another seed. */
  function begin(value: number) {
    first.value = value >>> 0;
    made = 0;
  }

  /** Sorts by the known scores, the best first, and again when the model has scored all styles. */
  function sort() {
    scores.ask();
    isSorting = scores.progress.peek() !== null;
    sorted.value = true;
    wall.sort(scores.points);
  }

  function finishSort() {
    if (isSorting) wall.sort(scores.points);
    isSorting = false;
  }

  /** Chooses the first parent, or combines it with this style. */
  async function breed(style: Style, photo: Photo) {
    const other = parent.peek();
    parent.value = other ? null : style;
    if (other && other.id !== style.id) await litter([other, style], surprise.peek(), photo);
  }

  async function moreLike(style: Style, photo: Photo) {
    await litter([style, style], Math.max(0.15, surprise.peek()), photo);
  }

  /** Children, inserted after the parent that was chosen last. */
  async function litter([a, b]: readonly [Style, Style], wild: number, photo: Photo) {
    const planner = store.planner.peek();
    if (!planner) return;
    const from = seed();
    const both: Parents = [a, b];
    lastParents.value = both;
    const child = (i: number) => {
      const style = planner.breedStyle({ a, b, seed: (from + i) >>> 0, surprise: wild });
      parents.set(style.id, both);
      return style;
    };
    await run(photo, TRIES, child, { choosy: true, behind: b.id, enough: LITTER });
  }

  /** Redraws the wall with another photo. Styles keep their position. */
  async function redraw(photo: Photo): Promise<boolean> {
    const stale = wall.items.peek().filter((item) => item.photo.id !== photo.id);
    if (stale.length === 0) return true;
    scores.forget();
    return work(
      photo,
      'redraw',
      stale.length,
      (i) => stale[i].style,
      (styles, explored) => {
        wall.redraw(photo, styles, explored);
        return 0;
      },
    );
  }

  /**
   * @param how `choosy`: rejects similar and damaged images; `behind`: inserts after this style (default: at the end);
   *   `enough`: number of styles to add (default: all); `together`: number of styles that are shown at once
   */
  async function run(
    photo: Photo,
    count: number,
    make: (i: number) => Style,
    {
      choosy,
      behind,
      enough = Infinity,
      together = 1,
      rounds,
    }: { choosy: boolean; behind?: string; enough?: number; together?: number; rounds?: Rounds },
  ): Promise<boolean> {
    let left = enough;
    let last = behind;
    const take = (styles: readonly Style[], explored: readonly Explored[]) => {
      const fresh = wall.sift(photo, styles, explored, { choosy, most: left, waiting });
      left -= fresh.length;
      if (together > 1) waiting.push(...fresh);
      else wall.hang(fresh, last);
      if (behind !== undefined) last = fresh.at(-1)?.style.id ?? last;
      if (waiting.length >= together) show();
      return fresh.length;
    };
    const whole = await work(photo, 'invent', count, make, take, { enough, rounds });
    if (whole) show();
    return whole;
  }

  /** Shows the waiting styles, the best first and harsh ones last. */
  function show() {
    const points = (item: Item) => scores.points(item) - HARSH * item.harsh;
    wall.hang([...waiting].sort((a, b) => points(b) - points(a)));
    waiting = [];
  }

  /**
   * Draws styles in batches.
   * @param take handles a batch and returns the number of added styles
   * @param how `rounds`: the rounds before, which share the progress
   * @returns whether it went to its end
   */
  async function work(
    photo: Photo,
    what: Doing['what'],
    count: number,
    make: (i: number) => Style,
    take: (styles: readonly Style[], explored: readonly Explored[]) => number,
    { enough = Infinity, rounds }: { enough?: number; rounds?: Rounds } = {},
  ): Promise<boolean> {
    if (!rounds || rounds.tried === 0) stop();
    const mine = new AbortController();
    running = mine;
    const total = Math.min(count, enough);
    let [next, done, hung] = [0, 0, 0];
    const tell = () => {
      progress.value = {
        what,
        ...(rounds
          ? overRounds({ tried: rounds.tried + done, added: rounds.added + hung })
          : { done: Math.min(total, enough < Infinity ? hung : done), total }),
      };
    };
    tell();
    const parcels = async () => {
      while (next < count && hung < enough && !mine.signal.aborted) {
        const styles = Array.from({ length: Math.min(PARCEL, count - next) }, (_, i) => make(next + i));
        next += styles.length;
        const explored = await engine.exploreStyles(photo.id, styles, photo, { signal: mine.signal });
        if (mine.signal.aborted) return;
        done += styles.length;
        hung += take(styles, explored);
        tell();
      }
    };
    try {
      await measurePlain(photo, mine.signal);
      await Promise.all(Array.from({ length: AHEAD }, parcels));
    } catch (error) {
      if (codeOf(error) !== 'cancelled') messages.alert(strings.explorerFailed({ why: explain(error) }));
      mine.abort();
    }
    if (running === mine) {
      running = null;
      if (!rounds) progress.value = null;
    }
    if (rounds) {
      rounds.tried += done;
      rounds.added += hung;
    }
    return !mine.signal.aborted;
  }

  /** Measures a photo without a style, once, to compare styles with it. */
  async function measurePlain(photo: Photo, signal: AbortSignal) {
    if (plain.has(photo.id) || !store.album.peek().get(photo.id)?.meta) return;
    for (const { bitmap, signature, clipped } of await engine.exploreStyles(photo.id, [PLAIN], photo, { signal })) {
      bitmap.close();
      plain.set(photo.id, { signature, clipped });
    }
  }

  function stop() {
    running?.abort();
    running = null;
    progress.value = null;
    show();
  }

  function clear() {
    stop();
    parent.value = null;
    parents.clear();
    lastParents.value = null;
    sorted.value = false;
    isSorting = false;
    scores.forget();
    wall.clear();
  }
}

/** The progress over all rounds. Their number is estimated from the part of the styles that is good. */
function overRounds({ tried, added }: Rounds): Progress {
  const current = Math.max(1, Math.ceil(tried / ROUND));
  const needed = added === 0 ? MAX_ROUNDS : Math.ceil((FAIR * tried) / added / ROUND);
  return { done: tried, total: ROUND * Math.max(current, Math.min(MAX_ROUNDS, needed)) };
}
