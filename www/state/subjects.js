// @ts-check
/**
 * What is in the photos: found one by one once the page is on the screen, those on the page first. The page's crops
 * follow; nobody waits for it.
 */

import { computed, effect, signal } from '@preact/signals';
import { strings } from '../strings.js';

/** @typedef {import('../engine/detector.js').Found} Found */
/** @typedef {import('./album.js').Fact} Fact */
/** @typedef {import('./store.js').Progress} Progress */
/** @typedef {ReturnType<typeof createSubjects>} Subjects */

/**
 * @param {{
 *   store: import('./store.js').Store, pages: import('./pages.js').Pages, messages: import('./messages.js').Messages,
 *   engine: Pick<import('../engine/engine.js').Engine, 'look' | 'lookCloser' | 'hasPhoto'>,
 *   painted: () => boolean, wanted?: boolean,
 * }} app `painted` reads signals: whether the page as it is now is on the screen; not `wanted`, nothing is looked at
 */
export function createSubjects({ store, pages, messages, engine, painted, wanted = true }) {
  /** How far each photo is; what failed counts as done. @type {Map<string, 'looked' | 'done'>} */
  const known = new Map();
  /** What the closer look begins with. @type {Map<string, Found[]>} */
  const first = new Map();
  /** @type {import('@preact/signals').Signal<Progress | null>} */
  const progress = signal(null);
  const off = signal(!wanted);
  const running = signal(false);
  /** Bumped when `known` changes. */
  const round = signal(0);

  const waiting = computed(() => {
    round.value;
    const read = store.facts.value.filter(({ id, meta }) => meta !== null && known.get(id) !== 'done' && engine.hasPhoto(id));
    const shown = new Set(store.page.value?.panels.map(({ photo }) => photo));
    const rank = (/** @type {Fact} */ { id }) => (known.has(id) ? 2 : 0) + (shown.has(id) ? 0 : 1);
    return read.sort((a, b) => rank(a) - rank(b));
  });
  /** Whether everything is found that will be. */
  const settled = computed(() => off.value || store.page.value === null || (!running.value && waiting.value.length === 0));

  effect(() => {
    const ready = store.page.value !== null && store.reading.value === null && painted();
    if (ready && !off.value && !running.value && waiting.value.length > 0) void run();
  });

  return { progress, settled };

  async function run() {
    running.value = true;
    try {
      let total = 0;
      // New photos begin another round when their page is drawn.
      while (waiting.peek().length > 0 && store.reading.peek() === null) {
        const [{ id }] = waiting.peek();
        const left = waiting.peek().filter((fact) => !known.has(fact.id)).length;
        total = Math.max(total, left);
        progress.value = left > 0 ? { done: total - left, total } : null;
        await look(id);
      }
    } catch {
      off.value = true;
      messages.note(strings.noDetector);
    } finally {
      progress.value = null;
      running.value = false;
    }
  }

  /** @param {string} id */
  async function look(id) {
    try {
      const before = first.get(id);
      if (before) {
        tell(id, await engine.lookCloser(id, before));
        known.set(id, 'done');
        first.delete(id);
      } else {
        const { boxes, closer } = await engine.look(id);
        tell(id, boxes);
        known.set(id, closer ? 'looked' : 'done');
        if (closer) first.set(id, boxes);
      }
    } catch (error) {
      // One photo that cannot be looked at is framed by contrast; without detectors all are.
      known.set(id, 'done');
      const { code } = /** @type {{ code?: string }} */ (error);
      if (code === 'detector-missing' || code === 'worker-lost' || code === 'detector') throw error;
    } finally {
      round.value += 1;
    }
  }

  /**
   * @param {string} id
   * @param {Found[]} subjects
   */
  function tell(id, subjects) {
    const fact = store.album.peek().get(id);
    if (!fact?.meta || JSON.stringify(fact.meta.subjects) === JSON.stringify(subjects)) return;
    store.know({ ...fact, meta: { ...fact.meta, subjects } });
    if (store.page.peek()?.panels.some(({ photo }) => photo === id)) pages.refine();
  }
}
