// @ts-check
/**
 * What is in the photos: found once the page is on the screen, those on the page first, then those on other pages,
 * faces and objects side by side. The crops follow; nobody waits for it.
 */

import { computed, effect, signal } from '@preact/signals';
import { strings } from '../strings.js';
import { photosOn } from './sheets.js';

/** @typedef {import('../engine/detector.js').Found} Found */
/** @typedef {import('./album.js').Fact} Fact */
/** @typedef {import('./store.js').Progress} Progress */
/** @typedef {ReturnType<typeof createSubjects>} Subjects */

/**
 * What was found in a photo so far; what failed counts as nothing found. `closer`: a look for small faces is due.
 * @typedef {{ faces?: Found[], objects?: Found[], closer?: boolean }} Looked
 */
/** @typedef {'faces' | 'objects'} Lane */

/** Without the detectors none of the other photos can be looked at. */
const FATAL = new Set(['detector-missing', 'worker-lost', 'detector']);

/**
 * @param {{
 *   store: import('./store.js').Store, pages: import('./pages.js').Pages, messages: import('./messages.js').Messages,
 *   engine: Pick<import('../engine/engine.js').Engine, 'loadDetectors' | 'findFaces' | 'findMoreFaces' | 'findObjects' | 'hasPhoto'>,
 *   painted: () => boolean, wanted?: boolean, window?: Pick<Window, 'addEventListener' | 'navigator'>,
 * }} app `painted` reads signals: whether the page as it is now is on the screen; not `wanted`, nothing is looked at
 */
export function createSubjects({ store, pages, messages, engine, painted, wanted = true, window = globalThis.window }) {
  /** @type {Map<string, Looked>} */
  const known = new Map();
  /** @type {import('@preact/signals').Signal<Progress | null>} */
  const progress = signal(null);
  const off = signal(!wanted);
  const running = signal(/** @type {ReadonlySet<Lane>} */ (new Set()));
  /** Whether the detectors could not be loaded, and whether that was said. */
  const lacking = { now: false, said: false };
  /** Bumped when `known` changes. */
  const round = signal(0);

  const photos = computed(() => {
    round.value;
    const [shown, beside] = [photosOn(store.page.value ? [store.page.value] : []), photosOn(store.sheets.value)];
    const rank = (/** @type {string} */ id) => (shown.has(id) ? 0 : beside.has(id) ? 1 : 2);
    const read = store.facts.value.filter(({ id, meta, looked }) => meta !== null && !looked && engine.hasPhoto(id));
    return read.map(({ id }) => id).sort((a, b) => rank(a) - rank(b));
  });
  /** Whether everything is found that will be. */
  const settled = computed(() => off.value || store.page.value === null || (running.value.size === 0 && !next('faces') && !next('objects')));

  /** Whether every photo was looked at by both, which most crops wait for; closer looks may go on. */
  const searched = computed(() => off.value || store.page.value === null || !photos.value.some(unsearched));

  effect(() => {
    if (off.value || store.page.value === null || !painted()) return;
    // While the last photos are read; a first page is on the screen.
    engine.loadDetectors();
    if (store.reading.value !== null) return;
    // What takes longer is first in line.
    for (const lane of /** @type {const} */ (['objects', 'faces'])) if (!running.value.has(lane) && next(lane)) void run(lane);
  });

  window?.addEventListener('online', () => {
    if (lacking.now) off.value = false;
    lacking.now = false;
  });

  return { progress, settled, searched };

  /**
   * The photo to look at next; a closer look waits until every photo was looked at.
   * @param {Lane} lane
   * @returns {string | undefined}
   */
  function next(lane) {
    const looked = (/** @type {string} */ id) => known.get(id) ?? {};
    const first = photos.value.find((id) => looked(id)[lane] === undefined);
    return first ?? (lane === 'faces' ? photos.value.find((id) => looked(id).closer) : undefined);
  }

  /** @param {Lane} lane */
  async function run(lane) {
    running.value = new Set([...running.peek(), lane]);
    try {
      // New photos begin another round when their page is drawn.
      for (let id = next(lane); id !== undefined && !off.peek() && store.reading.peek() === null; id = next(lane)) {
        count();
        known.set(id, { ...known.get(id), ...await look(lane, id) });
        tell(id);
        round.value += 1;
      }
    } catch (error) {
      if (!off.peek()) giveUp(/** @type {{ code?: string }} */ (error).code === 'detector-missing');
    } finally {
      running.value = new Set([...running.peek()].filter((other) => other !== lane));
      count();
    }
  }

  /** @param {string} id */
  function unsearched(id) {
    const { faces, objects } = known.get(id) ?? {};
    return !faces || !objects;
  }

  /** @param {boolean} missing whether they may be there later */
  function giveUp(missing) {
    const away = missing && window?.navigator.onLine === false;
    if (!lacking.said) messages.note(away ? strings.noDetectorOffline : strings.noDetector);
    lacking.said = true;
    lacking.now = missing;
    off.value = true;
  }

  /** Progress of the first looks; the closer ones change little. */
  function count() {
    const left = off.peek() ? 0 : photos.peek().filter(unsearched).length;
    const total = Math.max(progress.peek()?.total ?? 0, left);
    progress.value = left > 0 && running.peek().size > 0 ? { done: total - left, total } : null;
  }

  /**
   * @param {Lane} lane
   * @param {string} id
   * @returns {Promise<Looked>} what is new
   */
  async function look(lane, id) {
    const before = known.get(id)?.faces;
    try {
      if (lane === 'objects') return { objects: await engine.findObjects(id) };
      if (before) return { faces: await engine.findMoreFaces(id, before), closer: false };
      const { boxes, closer } = await engine.findFaces(id);
      return { faces: boxes, closer };
    } catch (error) {
      if (FATAL.has(/** @type {{ code: string }} */ (error).code)) throw error;
      // One photo that cannot be looked at is framed by contrast.
      return lane === 'objects' ? { objects: [] } : { faces: before ?? [], closer: false };
    }
  }

  /** Lets the page follow when both lanes have looked. @param {string} id */
  function tell(id) {
    const { faces, objects, closer } = known.get(id) ?? {};
    const fact = store.album.peek().get(id);
    if (!faces || !objects || !fact?.meta) return;
    const subjects = [...faces, ...objects];
    const same = JSON.stringify(fact.meta.subjects) === JSON.stringify(subjects);
    // What is found once is found: the next visit need not look again.
    if (!same || !closer) store.know({ ...fact, meta: same ? fact.meta : { ...fact.meta, subjects }, ...(closer ? {} : { looked: true }) });
    if (!same && store.page.peek()?.panels.some(({ photo }) => photo === id)) pages.refine();
  }
}
