// @ts-check
/**
 * Saves by itself: a moment after a change, and at the latest after a second of changes. It says `saved` only when what
 * was written was read back. A change that comes while it writes begins another round.
 *
 * What is written goes to the place that its snapshot names, and what is known of the saving of a project is known of its
 * place: whatever comes and goes on the page, no project is written in the place of another.
 */

import { effect, signal, untracked } from '@preact/signals';
import { failure } from '../../engine/protocol.js';
import { freshId } from '../fresh-id.js';
import { isFull } from './database.js';
import { drawnId } from './drawn-states.js';
import { PHOTOS_LOCK } from './locks.js';
import { adopt } from './orphans.js';
import { snapshotOf } from './snapshot.js';
import { VERSION } from './versions.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./snapshot.js').Snapshot} Snapshot */
/** @typedef {import('../place.js').Place} Place */
/** @typedef {'empty' | 'saving' | 'saved' | 'full' | 'refused' | 'failed'} Status */
/**
 * What is known of the saving of one project: `facts` as they were written, `clean` is what there was when nothing needed
 * saving, `inFile` what was saved as a file, `since` when the first change came that is not written.
 * @typedef {{ place: Place, facts: Map<string, import('../album.js').Fact>, clean: unknown[], dirty: boolean, inFile: unknown, since: number, status: Status }} Ledger
 */
/** @typedef {ReturnType<typeof createSaving>} Saving */

/** Milliseconds. */
const QUIET = 250;
const LONGEST = 1000;

/**
 * @param {{
 *   store: import('../store.js').Store, records: import('./photo-records.js').PhotoRecords, locks: import('./locks.js').Locks,
 *   database: () => Promise<Database>, drawnStates: Pick<import('./drawn-states.js').DrawnStates, 'of'>,
 *   onTrouble: (status: Status, error: Error) => void, onSaved?: (place: Place) => void,
 * }} app
 */
export function createSaving({ store, records, locks, database, drawnStates, onTrouble, onSaved = () => {} }) {
  /** @type {import('@preact/signals').Signal<Status>} */
  const status = signal('empty');
  /** A project that another took the place of for a moment is known as it was. @type {WeakMap<Place, Ledger>} */
  const ledgers = new WeakMap();
  let ledger = ledgerOf(store.place.peek());
  /** @type {Promise<void> | null} */
  let running = null;
  /** @type {any} */
  let timer;

  effect(() => {
    const place = store.place.value;
    const now = parts();
    untracked(() => {
      if (place !== ledger.place) turnTo(place);
      touch(now);
    });
  });

  return { status, flush, isSafe, filed };

  function parts() {
    return [store.history.value, store.album.value, store.videos.value];
  }

  /** @param {Place} place @returns {Ledger} */
  function ledgerOf(place) {
    const known = ledgers.get(place);
    if (known) return known;
    const kept = place.stamp !== '';
    // What came out of the database is there; what is new is yet to be written.
    const facts = new Map(kept ? store.album.peek() : []);
    /** @type {Ledger} */
    const fresh = { place, facts, clean: kept ? parts() : [], dirty: false, inFile: null, since: 0, status: kept ? 'saved' : 'empty' };
    ledgers.set(place, fresh);
    return fresh;
  }

  /** @param {Place} place */
  function turnTo(place) {
    clearTimeout(timer);
    ledger.status = status.peek();
    ledger = ledgerOf(place);
    status.value = ledger.status;
  }

  /** @param {unknown[]} now */
  function touch(now) {
    if (now.every((part, i) => part === ledger.clean[i])) return;
    const { tray, name } = store.project.peek();
    if (ledger.place.stamp === '' && tray.length === 0 && name === '') return;
    if (!ledger.dirty) ledger.since = performance.now();
    ledger.dirty = true;
    if (status.peek() === 'saved' || status.peek() === 'empty') status.value = 'saving';
    clearTimeout(timer);
    timer = setTimeout(save, Math.max(0, Math.min(QUIET, ledger.since + LONGEST - performance.now())));
  }

  /** @returns {Promise<void>} when all that there is now was written, or could not be */
  async function flush() {
    clearTimeout(timer);
    if (running) await running;
    if (ledger.dirty) await save();
  }

  function save() {
    running ??= rounds().finally(() => {
      running = null;
    });
    return running;
  }

  async function rounds() {
    while (ledger.dirty) {
      const of = ledger;
      of.dirty = false;
      of.since = performance.now();
      const now = untracked(parts);
      try {
        await write(of);
        of.clean = now;
        if (!of.dirty && of === ledger) status.value = 'saved';
        onSaved(of.place);
      } catch (error) {
        // Tried again with the next change.
        of.dirty = true;
        const { code, name } = /** @type {{ code?: string, name?: string }} */ (error);
        const why = isFull(error) ? 'full' : code === 'no-storage' || name === 'SecurityError' ? 'refused' : 'failed';
        if (of !== ledger) return;
        status.value = why;
        onTrouble(why, /** @type {Error} */ (error));
        return;
      }
    }
  }

  /** @param {Ledger} of */
  async function write({ facts }) {
    const shot = snapshotOf(store, drawnStates.of(store.place.peek()));
    const base = await database();
    const stamp = freshId();
    await locks.during(PHOTOS_LOCK, { mode: 'shared' }, async () => {
      const photos = await records.write(base, shot.facts);
      const { videos, written } = await records.writeVideos(base, shot.videos);
      await writeState(base, shot, { stamp, videos, facts });
      shot.place.stamp = stamp;
      await readBack(base, shot);
      await records.verify(base, [...photos, ...written]);
    });
  }

  /**
   * @param {Database} base
   * @param {Snapshot} shot
   * @param {{ stamp: string, videos: import('./database.js').KeptVideo[], facts: Ledger['facts'] }} about
   */
  async function writeState(base, { place: { id, created, stamp: before }, history, drawn, facts: known }, { stamp, videos, facts }) {
    const all = base.transaction(['projects', 'states', 'facts'], 'readwrite');
    const projects = all.objectStore('projects');
    const ids = known.map((fact) => fact.id);
    try {
      const found = await projects.get(id);
      if ((found?.stamp ?? '') !== before) throw failure('conflict', 'Another tab has changed this project.');
      const { name, tray } = history.present;
      const refs = [...ids, ...videos.map(({ fileKey }) => fileKey)];
      const about = { ...(found?.held && { held: found.held }), id, name, created, changed: Date.now(), stamp, photos: tray.length, refs, gone: null };
      await adopt(all.objectStore('states'), refs);
      const fresh = known.filter((fact) => facts.get(fact.id) !== fact);
      await Promise.all([
        projects.put({ ...about, picture: found?.picture ?? null }),
        all.objectStore('states').put({ id, version: VERSION, stamp, history, facts: ids, videos }),
        ...(drawn.length > 0 ? [all.objectStore('states').put(/** @type {any} */ ({ id: drawnId(id), version: VERSION, drawn, facts: ids }))] : []),
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
   */
  async function readBack(base, { place: { id, stamp }, history }) {
    const [project, state] = await Promise.all([base.get('projects', id), base.get('states', id)]);
    const size = (/** @type {import('./database.js').KeptHistory} */ { past, future, shown }) => `${past.length} ${future.length} ${shown.length}`;
    const same = project?.stamp === stamp && state?.stamp === stamp && size(state.history) === size(history) &&
      JSON.stringify(state.history.present) === JSON.stringify(history.present);
    if (!same) throw new Error('What was saved could not be read back.');
  }

  /** Whether nothing is lost when another project takes the place of this one. */
  function isSafe() {
    if (store.tray.peek().length === 0 && ledger.place.stamp === '') return true;
    return store.history.peek() === ledger.inFile || (!ledger.dirty && running === null && (status.peek() === 'saved' || status.peek() === 'empty'));
  }

  /** What there is now is in a file. */
  function filed() {
    ledger.inFile = store.history.peek();
  }
}
