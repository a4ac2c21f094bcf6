/**
 * Invented styles that a shuffle may draw. Each style is tested on three photos of the page at 448 pixels. A style is
 * rejected if an image is almost empty, or if its score is below most built-in styles. A few tested styles are cached,
 * made in idle time.
 */

import { effect, signal } from '@preact/signals';
import { coloured } from './colouring.ts';
import { damageOf, isClipped } from './damage.ts';
import { PLAIN } from '../photos/cover.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Explored } from '../engine/protocol.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Style } from '../engine/types.ts';

export type Inventions = ReturnType<typeof createInventions>;
type Tried = { id: string; width: number; height: number };
/** By photo id. */
type Plain = Map<string, Pick<Explored, 'signature' | 'clipped'>>;

/** The longer side of a picture that is judged, and the photos that each style is judged on. */
const SIDE = 448;
const PHOTOS = 3;
/**
 * Number of cached styles, of styles per test, and of tested styles per page. For some photos only few styles are good.
 */
const READY = 6;
const PARCEL = 4;
const TRIES = 48;
/** Minimum score of a style, from 0 to 1 by simple measures, and from 1 to 10 by the model. */
const LEAST = 0.5;
const LEAST_JUDGED = 4.5;
/** Milliseconds of rest before the work begins. It takes several seconds, and a later shuffle uses its result. */
const REST = 3000;

/** @param app `idle`: whether no other task is running; `judged`: whether to use the aesthetics model */
export function createInventions({
  store,
  engine,
  seed,
  idle,
  judged: wanted = true,
  scheduler,
}: {
  store: Store;
  engine: Pick<Engine, 'exploreStyles' | 'judges' | 'judgeStyle' | 'hasPhoto'>;
  seed: () => number;
  idle: () => boolean;
  judged?: boolean;
  scheduler: Scheduler;
}) {
  const ready = signal([] as readonly Style[]);
  let stop = new AbortController();
  let place = '';

  effect(() => {
    const page = store.page.value;
    // Another project has other photos.
    if (store.place.value.id !== place) ready.value = [];
    place = store.place.value.id;
    const share = store.project.value.styling.invented;
    // One that is on the page was drawn: the next shuffle has another.
    const shown = typeof page?.style === 'string' ? page.style : page?.style.id;
    if (ready.peek().some(({ id }) => id === shown)) ready.value = ready.peek().filter(({ id }) => id !== shown);
    stop.abort();
    if (!page || share === 0 || !idle()) return;
    stop = new AbortController();
    const { signal } = stop;
    scheduler.background(() => fill(signal), { rest: REST, signal });
  });

  return { ready };

  async function fill(stop: AbortSignal) {
    const photos = tried();
    const plain: Plain = new Map();
    try {
      for (let count = 0; photos.length > 0 && count < TRIES && ready.peek().length < READY; count += PARCEL) {
        const good = await parcel(photos, plain, stop);
        if (stop.aborted) return;
        ready.value = [...ready.peek(), ...good];
      }
    } catch {
      // Stopped, or a photo went while it was tried: the next page tries again.
    }
  }

  /**
   * @param plain measurements of photos without a style. Missing ones are added
   * @returns the good styles of a new batch, on all photos
   */
  async function parcel(photos: readonly Tried[], plain: Plain, stop: AbortSignal): Promise<Style[]> {
    const planner = store.planner.peek();
    if (!planner) return [];
    const [from, blocks] = [seed(), planner.blocks()];
    const all = Array.from({ length: PARCEL }, (_, i) => (from + i) >>> 0);
    let styles = all.map((at) => coloured(planner.inventStyle(at), at, blocks));
    for (const photo of photos) {
      const asked = plain.has(photo.id) ? styles : [...styles, PLAIN];
      const explored = await engine.exploreStyles(photo.id, asked, photo, { signal: stop });
      for (const { bitmap } of explored) bitmap.close();
      const own = plain.get(photo.id) ?? explored.find(({ index }) => index === styles.length);
      if (own) plain.set(photo.id, own);
      const meta = store.album.peek().get(photo.id)?.meta;
      const isWhole = (signature?: Uint8Array) =>
        !meta || !signature || damageOf(meta, signature, own?.signature) === '';
      const good = explored.filter(
        (one) =>
          one.index < styles.length &&
          one.fault === '' &&
          one.score >= LEAST &&
          isWhole(one.signature) &&
          !isClipped(one, own?.clipped),
      );
      styles = good.map(({ index }) => styles[index]);
      if (styles.length === 0) return [];
    }
    if (!wanted || !engine.judges) return styles;
    const judged: Style[] = [];
    for (const style of styles) {
      let sum = 0;
      for (const photo of photos)
        sum += await engine.judgeStyle(photo.id, style, photo, { signal: stop, lane: 'background' });
      if (sum / photos.length >= LEAST_JUDGED) judged.push(style);
    }
    return judged;
  }

  /** Photos of the page at the size at which they are judged. */
  function tried(): Tried[] {
    const shown = new Set(store.page.peek()?.panels.flatMap(({ photo }) => photo ?? []));
    return store.facts
      .peek()
      .flatMap(({ id, meta }) => (meta && shown.has(id) && engine.hasPhoto(id) ? [{ id, ...sized(meta) }] : []))
      .slice(0, PHOTOS);
  }
}

function sized({ width, height }: { width: number; height: number }) {
  const scale = SIDE / Math.max(width, height, 1);
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}
