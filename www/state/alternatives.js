// @ts-check
/**
 * An endless stream of other pages, made as they come into view. It depends on the photos that are free for the page, the page
 * settings, the wanted number of panels and what is locked, single panels too: while these stand, so does the
 * stream, whichever of its pages is chosen.
 */

import { computed, signal } from '@preact/signals';
import { photosFor } from './page-photos.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('./pages.js').Pages} Pages */
/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {ReturnType<typeof createAlternatives>} Alternatives */

/** Seeds are tried this often for a page that is not in the stream yet; then there are no more. */
const TRIES = 12;
/** Milliseconds that pages are made at a stretch: a frame's time, so that nothing else on the page waits. */
const STRETCH = 12;

/**
 * @param {{ store: Store, pages: Pages }} app
 */
export function createAlternatives({ store, pages }) {
  /** What the stream depends on, as text. */
  const basis = computed(() => {
    const { project, photos, reading, planner } = store;
    const { page, locks, panels, settings, styling, others, sheet } = project.value;
    // The first page comes first; nothing else is drawn while it waits for photos.
    if (!planner.value || !page || reading.value) return '';
    return JSON.stringify([
      photosFor(photos.value, others.map((other) => other.page), page).map(({ id }) => id), sheet, settings, panels, locks, styling, locks.layout && page.layout, locks.style && page.style,
      locks.photos && [page.order, page.panels],
      page.panels.filter(({ locked }) => locked).map(({ photo }) => photo),
    ]);
  });

  /** @type {import('@preact/signals').Signal<{ basis: string, items: readonly PageDocument[], over: boolean }>} */
  const stream = signal({ basis: '', items: [], over: false });
  const empty = { items: /** @type {readonly PageDocument[]} */ ([]), over: false };
  let running = false;

  return {
    basis,
    /** The pages made so far. */
    items: computed(() => (stream.value.basis === basis.value ? stream.value : empty).items),
    more,
  };

  /**
   * Makes the stream longer, a few pages at a stretch.
   * @param {number} count
   */
  async function more(count) {
    if (running) return;
    running = true;
    try {
      const now = basis.peek();
      const goal = current(now).items.length + count;
      while (now !== '' && basis.peek() === now && !current(now).over && current(now).items.length < goal) {
        stretch(now, goal);
        await new Promise((resolve) => { setTimeout(resolve); });
      }
    } finally {
      running = false;
    }
    // What it depends on has changed meanwhile, and nobody else would begin again.
    if (basis.peek() !== '' && current(basis.peek()).items.length === 0 && !current(basis.peek()).over) await more(count);
  }

  /** @param {string} now */
  function current(now) {
    return stream.peek().basis === now ? stream.peek() : empty;
  }

  /**
   * @param {string} now
   * @param {number} goal
   */
  function stretch(now, goal) {
    const fresh = [...current(now).items];
    const known = new Set(fresh.map(look));
    const end = performance.now() + STRETCH;
    let tries = 0;
    while (fresh.length < goal && tries < TRIES && (performance.now() < end || tries > 0)) {
      const page = pages.plan({ keep: { ...store.project.peek().locks }, mode: 'shuffle' });
      if (!page || known.has(look(page))) {
        tries += 1;
        continue;
      }
      tries = 0;
      known.add(look(page));
      fresh.push(page);
    }
    stream.value = { basis: now, items: fresh, over: tries >= TRIES };
  }
}

/**
 * @param {PageDocument} page
 * @returns {string} the same for pages that look the same
 */
function look(page) {
  return JSON.stringify({ ...page, seed: 0 });
}
