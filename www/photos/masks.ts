/**
 * Detects subject masks, for panel breakouts. It runs after all other detection, one photo at a time, photos on pages
 * first. It has low priority.
 */

import { computed, effect, signal } from '@preact/signals';
import { photosOn } from '../engine/sheets.ts';
import type { Progress, Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

export type Masks = ReturnType<typeof createMasks>;

/** Number of photos outside of pages that are processed as well, because the next shuffle may use them. */
const BESIDE = 24;

/**
 * @param app `ready`: whether no other work is waiting. `wanted`: whether detection is enabled. `onFound` is called
 *   when all photos of the page are done, so that its crops can use the masks.
 */
export function createMasks({
  store,
  engine,
  ready,
  onFound = () => {},
  wanted = true,
}: {
  store: Store;
  engine: Pick<Engine, 'masks' | 'findMask' | 'hasPhoto' | 'knowMask'>;
  ready: () => boolean;
  onFound?: () => void;
  wanted?: boolean;
}) {
  /** Photos that could not be looked at. */
  const failed: Signal<ReadonlySet<string>> = signal(new Set());
  const off = signal(!wanted || !engine.masks);
  const running = signal(false);
  const stopped = signal(false);
  /** Ends the look at a photo. */
  let looking: AbortController | undefined;
  const progress: Signal<Progress | null> = signal(null);

  const due: ReadonlySignal<readonly string[]> = computed(() => {
    if (off.value) return [];
    const [shown, beside] = [photosOn(store.page.value ? [store.page.value] : []), photosOn(store.sheets.value)];
    const rank = (id: string) => (shown.has(id) ? 0 : beside.has(id) ? 1 : 2);
    const all = store.facts.value.filter(({ id, meta, absent }) => meta && !absent && engine.hasPhoto(id));
    const spare = BESIDE - all.filter(({ id, meta }) => rank(id) === 2 && meta?.mask).length;
    // Corrected masks count as known.
    const open = all.filter(({ id }) => !store.masks.value.has(id) && !failed.value.has(id)).map(({ id }) => id);
    const ofPages = open.filter((id) => rank(id) < 2).sort((a, b) => rank(a) - rank(b));
    return [...ofPages, ...open.filter((id) => rank(id) === 2).slice(0, Math.max(0, spare))];
  });

  /** The masks that were passed to the engine. */
  let told: ReadonlyMap<string, string> = new Map();

  // New drawings use all masks, including masks of opened projects and corrections.
  effect(() => {
    const masks = store.masks.value;
    for (const id of new Set([...told.keys(), ...masks.keys()])) {
      if (masks.get(id) !== told.get(id)) engine.knowMask(id, masks.get(id));
    }
    told = masks;
  });

  effect(() => {
    if (!running.value && !stopped.value && due.value.length > 0 && ready()) void run();
  });

  return {
    there: computed(() => !off.value),
    progress,
    settled: computed(() => stopped.value || due.value.length === 0),
    /** Whether the user stopped the search. Only `goOn` continues it. */
    held: computed(() => stopped.value && due.value.length > 0),
    stop,
    goOn: () => {
      stopped.value = false;
    },
  };

  function stop() {
    stopped.value = true;
    looking?.abort();
  }

  async function run() {
    running.value = true;
    let done = 0;
    try {
      while (!stopped.peek() && due.peek().length > 0 && ready()) {
        const [id] = due.peek();
        progress.value = { done, total: done + due.peek().length };
        await look(id);
        done += 1;
        const shown = photosOn(store.page.peek() ? [store.page.peek() as PageDocument] : []);
        if (!stopped.peek() && shown.has(id) && !due.peek().some((other) => shown.has(other))) onFound();
      }
    } finally {
      progress.value = null;
      running.value = false;
    }
  }

  async function look(id: string) {
    looking = new AbortController();
    const { signal: left } = looking;
    try {
      const mask = await engine.findMask(id, { signal: left });
      const fact = store.album.peek().get(id);
      if (fact?.meta) store.know({ ...fact, meta: { ...fact.meta, mask } });
    } catch (error) {
      if (left.aborted) return;
      const { code } = error as { code?: string };
      // Without the net nothing can be looked at; one photo that fails is one.
      if (code === 'detector-missing' || code === 'net-missing') off.value = true;
      failed.value = new Set([...failed.peek(), id]);
    }
  }
}
