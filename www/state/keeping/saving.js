// @ts-check
/**
 * Saves by itself: a moment after a change, and at the latest after a second of changes. It says `saved` only when what
 * was written was read back. A change that comes while it writes begins another round.
 */

import { effect, signal, untracked } from '@preact/signals';
import { failure } from '../../engine/protocol.js';
import { freshId } from '../fresh-id.js';
import { isFull } from './database.js';
import { PHOTOS_LOCK } from './locks.js';
import { snapshotOf } from './snapshot.js';
import { VERSION } from './versions.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./snapshot.js').Snapshot} Snapshot */
/** @typedef {{ id: string, stamp: string, created: number }} Place where the open project is kept; no `stamp`: nowhere yet */
/** @typedef {'empty' | 'saving' | 'saved' | 'full' | 'refused' | 'failed'} Status */
/** @typedef {ReturnType<typeof createSaving>} Saving */

/** Milliseconds. */
const QUIET = 250;
const LONGEST = 1000;

/**
 * @param {{
 *   store: import('../store.js').Store, records: import('./photo-records.js').PhotoRecords, locks: import('./locks.js').Locks,
 *   database: () => Promise<Database>, place: import('@preact/signals').Signal<Place>,
 *   onTrouble: (status: Status, error: Error) => void, onSaved?: () => void,
 * }} app
 */
export function createSaving({ store, records, locks, database, place, onTrouble, onSaved = () => {} }) {
  /** @type {import('@preact/signals').Signal<Status>} */
  const status = signal('empty');
  /** Facts as they were written. @type {Map<string, import('../album.js').Fact>} */
  const facts = new Map();
  /** What there was when nothing needed saving. @type {unknown[]} */
  let clean = [];
  /** @type {Promise<void> | null} */
  let running = null;
  let dirty = false;
  /** What was saved as a file. @type {unknown} */
  let inFile = null;
  let since = 0;
  /** @type {any} */
  let timer;

  effect(() => {
    const now = parts();
    untracked(() => touch(now));
  });

  return { status, flush, adopt, isSafe, filed };

  function parts() {
    return [store.history.value, store.album.value, store.videos.value];
  }

  /** @param {unknown[]} now */
  function touch(now) {
    if (now.every((part, i) => part === clean[i])) return;
    const { tray, name } = store.project.peek();
    if (place.peek().stamp === '' && tray.length === 0 && name === '') return;
    if (!dirty) since = performance.now();
    dirty = true;
    if (status.peek() === 'saved' || status.peek() === 'empty') status.value = 'saving';
    clearTimeout(timer);
    timer = setTimeout(save, Math.max(0, Math.min(QUIET, since + LONGEST - performance.now())));
  }

  /** @returns {Promise<void>} when all that there is now was written, or could not be */
  async function flush() {
    clearTimeout(timer);
    if (running) await running;
    if (dirty) await save();
  }

  function save() {
    running ??= rounds().finally(() => {
      running = null;
    });
    return running;
  }

  async function rounds() {
    while (dirty) {
      dirty = false;
      since = performance.now();
      const now = [store.history.peek(), store.album.peek(), store.videos.peek()];
      try {
        await write();
        clean = now;
        if (!dirty) status.value = 'saved';
        onSaved();
      } catch (error) {
        // Tried again with the next change.
        dirty = true;
        const { code, name } = /** @type {{ code?: string, name?: string }} */ (error);
        const why = isFull(error) ? 'full' : code === 'no-storage' || name === 'SecurityError' ? 'refused' : 'failed';
        status.value = why;
        onTrouble(why, /** @type {Error} */ (error));
        return;
      }
    }
  }

  async function write() {
    const { id, stamp: before, created } = place.peek();
    const shot = snapshotOf(store);
    const base = await database();
    const stamp = freshId();
    await locks.during(PHOTOS_LOCK, { mode: 'shared' }, async () => {
      const photos = await records.write(base, shot.facts);
      const { videos, written } = await records.writeVideos(base, shot.videos);
      await writeState(base, shot, { id, before, stamp, created, videos });
      place.value = { id, stamp, created };
      await readBack(base, shot, { id, stamp });
      await records.verify(base, [...photos, ...written]);
    });
  }

  /**
   * @param {Database} base
   * @param {Snapshot} shot
   * @param {{ id: string, before: string, stamp: string, created: number, videos: import('./database.js').KeptVideo[] }} about
   */
  async function writeState(base, { history, facts: known }, { id, before, stamp, created, videos }) {
    const all = base.transaction(['projects', 'states', 'facts'], 'readwrite');
    const projects = all.objectStore('projects');
    const ids = known.map((fact) => fact.id);
    try {
      const found = await projects.get(id);
      if ((found?.stamp ?? '') !== before) throw failure('conflict', 'Another tab has changed this project.');
      const { name, tray } = history.present;
      const refs = [...ids, ...videos.map(({ fileKey }) => fileKey)];
      const about = { id, name, created, changed: Date.now(), stamp, photos: tray.length, refs, gone: null };
      const fresh = known.filter((fact) => facts.get(fact.id) !== fact);
      await Promise.all([
        projects.put({ ...about, picture: found?.picture ?? null }),
        all.objectStore('states').put({ id, version: VERSION, stamp, history, facts: ids, videos }),
        ...fresh.map((fact) => all.objectStore('facts').put({ id: fact.id, fact })),
        all.done,
      ]);
      for (const fact of fresh) facts.set(fact.id, fact);
    } catch (error) {
      // What the transaction itself has to say comes a second time with its end.
      all.done.catch(() => {});
      throw error;
    }
  }

  /**
   * @param {Database} base
   * @param {Snapshot} shot
   * @param {{ id: string, stamp: string }} about
   */
  async function readBack(base, { history }, { id, stamp }) {
    const [project, state] = await Promise.all([base.get('projects', id), base.get('states', id)]);
    const size = (/** @type {import('./database.js').KeptHistory} */ { past, future, shown }) => `${past.length} ${future.length} ${shown.length}`;
    const same = project?.stamp === stamp && state?.stamp === stamp && size(state.history) === size(history) &&
      JSON.stringify(state.history.present) === JSON.stringify(history.present);
    if (!same) throw new Error('What was saved could not be read back.');
  }

  /** Whether nothing is lost when another project takes the place of this one. */
  function isSafe() {
    if (store.tray.peek().length === 0 && place.peek().stamp === '') return true;
    return store.history.peek() === inFile || (!dirty && running === null && (status.peek() === 'saved' || status.peek() === 'empty'));
  }

  /** What there is now is in a file. */
  function filed() {
    inFile = store.history.peek();
  }

  /** What there is now is in the database, or need not be. @param {Status} as */
  function adopt(as) {
    clearTimeout(timer);
    dirty = false;
    facts.clear();
    clean = [store.history.peek(), store.album.peek(), store.videos.peek()];
    for (const fact of store.album.peek().values()) if (as === 'saved') facts.set(fact.id, fact);
    status.value = as;
  }
}
