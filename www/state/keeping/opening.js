// @ts-check
/**
 * Which project is on the page. A project is open in one tab at a time; a tab that finds it taken offers a copy, and
 * opens it when the other lets go.
 */

import { computed, effect, signal } from '@preact/signals';
import { failure } from '../../engine/protocol.js';
import { strings } from '../../strings.js';
import { EMPTY_HISTORY } from '../history.js';
import { freshPlace } from '../place.js';
import { joined } from '../shared-lists.js';
import { projectLock } from './locks.js';
import { exchanged, readProject, rehearsed } from './restoring.js';

/** @typedef {import('./restoring.js').Content} Content */
/** @typedef {import('../place.js').Place} Place */
/** @typedef {ReturnType<typeof createOpening>} Opening */

/** A page that is loaded again waits so long for its former self to let go, in ms. */
const PATIENCE = 2_000;

/**
 * @param {{
 *   store: import('../store.js').Store, reading: Pick<import('../reading.js').Reading, 'resume'>,
 *   engine: Pick<import('../../engine/engine.js').Engine, 'ready' | 'photos'>, shelves: Pick<import('./shelves.js').Shelves, 'lists'>,
 *   saving: import('./saving.js').Saving, records: import('./photo-records.js').PhotoRecords, locks: import('./locks.js').Locks,
 *   messages: Pick<import('../messages.js').Messages, 'alert'>, database: () => Promise<import('./database.js').Database>,
 *   journal: Pick<import('./journal.js').Journal, 'recall' | 'names'>, last: ReturnType<typeof import('./last-project.js').createLastProject>,
 *   leave: () => void, onMissing: (photos: readonly { id: string, name: string }[]) => void, onUnwritten: (names: readonly string[]) => void,
 * }} app `leave` closes what belongs to the project before; `onMissing`: photos of a project that was opened are not here;
 *   `onUnwritten`: photos of a project of which nothing was written
 */
export function createOpening({
  store, reading, engine, shelves, saving, records, locks, messages, database, journal, last, leave, onMissing, onUnwritten,
}) {
  /** The project that another tab has open. @type {import('@preact/signals').Signal<{ id: string, name: string, follows: boolean } | null>} */
  const elsewhere = signal(null);
  const first = last.recall();
  /** Whether the project of the last visit is still on its way. */
  const running = signal(first !== null);
  /** Photos on their way belong to the project that is there. */
  const busy = computed(() => store.reading.value !== null || store.fetching.value);
  let release = () => {};
  /** Ends the waiting for a project that another tab has. */
  let waiting = new AbortController();

  return { elsewhere, running, busy, current: computed(() => store.place.value.id), begin, open, create, enter, goOnAsCopy, say };

  /** Opens what this tab had open, or else what was open last. */
  async function begin() {
    try {
      if (first) await openLast(first);
      else await settle(store.place.peek());
    } catch (error) {
      say(error);
    } finally {
      running.value = false;
    }
  }

  /** @param {{ id: string, here: boolean }} last */
  async function openLast({ id, here }) {
    const base = await database();
    const project = await base.get('projects', id);
    if (!project && here) onUnwritten(journal.names(id));
    if (!project || project.gone !== null) return settle(store.place.peek());
    const free = await locks.take(projectLock(id), here ? PATIENCE : 0);
    if (free) return load(id, free).catch((error) => { free(); throw error; });
    await settle(store.place.peek());
    elsewhere.value = { id, name: project.name, follows: true };
    void follow(id);
  }

  /** Opens a project when the tab that has it lets go, unless something was begun here meanwhile. @param {string} id */
  async function follow(id) {
    const { signal: stop } = waiting;
    const free = await locks.wait(projectLock(id), stop).catch(() => null);
    if (!free) return;
    if (elsewhere.peek()?.id !== id || store.tray.peek().length > 0) free();
    else await load(id, free).catch((error) => { free(); say(error); });
  }

  /**
   * @param {string} id
   * @returns {Promise<boolean>} whether it is the one on the page now
   */
  async function open(id) {
    if (id === store.place.peek().id) return true;
    const free = await locks.take(projectLock(id));
    if (!free) {
      elsewhere.value = { id, name: (await (await database()).get('projects', id))?.name ?? '', follows: false };
      return false;
    }
    try {
      await load(id, free);
      return true;
    } catch (error) {
      free();
      say(error);
      return false;
    }
  }

  /** @param {string} id @param {() => void} free lets go of its lock */
  async function load(id, free) {
    const { content, ...place } = await readable(id);
    await enter({ id, ...place }, content, free);
    records.know(content.records);
    if (content.missing?.length) onMissing(content.missing);
    if (content.filmless?.length) messages.alert(strings.filmsNotHere(content.filmless));
    void reading.resume(content.unread, content.films);
  }

  /** A project with what the journal tells of it, unless that makes one that cannot be shown. @param {string} id */
  async function readable(id) {
    const base = await database();
    const found = await readProject(base, id, journal.recall);
    if (!found.stored) return found;
    try {
      rehearsed(found.content, { planner: await engine.ready, shared: shelves.lists() });
      return found;
    } catch {
      return readProject(base, id);
    }
  }

  /** An empty project in the place of this one. @returns {Promise<boolean>} whether it came to that */
  async function create() {
    try {
      await enter(freshPlace(), { history: EMPTY_HISTORY, album: new Map(), videos: new Map(), records: [], unread: [] });
      return true;
    } catch (error) {
      say(error);
      return false;
    }
  }

  /**
   * Puts a project in the place of the one on the page, once that is saved (else it rejects with `not-saved`) and once
   * this one was found to be such as can be shown. Until then nothing changes; what fails after that is taken back.
   * @param {Place} next
   * @param {Content} content
   * @param {() => void} [free] lets go of its lock, where it is held already
   * @param {{ join?: boolean }} [how] `join`: its styles and layouts are added to those of this browser
   */
  async function enter(next, content, free, { join = false } = {}) {
    const planner = await engine.ready;
    await allRead();
    const lock = free ?? await locks.take(projectLock(next.id)) ?? (() => {});
    try {
      const whole = rehearsed(content, { planner, shared: join ? joined(content.history.present, shelves.lists()) : shelves.lists() });
      await saving.flush();
      if (!saving.isSafe()) throw failure('not-saved', 'This project is not saved.');
      exchanged(whole, next, { store, photos: engine.photos });
    } catch (error) {
      lock();
      throw error;
    }
    arrived(next, lock);
    leave();
  }

  /** What is on the page goes on as a project of its own; the one that it was stays as it is. */
  async function goOnAsCopy() {
    const next = freshPlace();
    const lock = await locks.take(projectLock(next.id)) ?? (() => {});
    const [history, album, videos] = [store.history.peek(), store.album.peek(), store.videos.peek()];
    store.load({ history, album, videos, place: next });
    arrived(next, lock);
  }

  /** Photos on their way arrive first. @returns {Promise<void>} */
  function allRead() {
    return new Promise((resolve) => {
      const stop = effect(() => {
        if (!busy.value) queueMicrotask(() => { stop(); resolve(); });
      });
    });
  }

  /** @param {Place} place that is on the page */
  async function settle(place) {
    arrived(place, await locks.take(projectLock(place.id)) ?? (() => {}));
  }

  /** @param {Place} place @param {() => void} lock */
  function arrived(place, lock) {
    release();
    release = lock;
    waiting.abort();
    waiting = new AbortController();
    elsewhere.value = null;
    last.opened(place.id);
  }

  /** @param {unknown} error */
  function say(error) {
    const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
    messages.alert(strings.projectNotOpened(strings.projectReasons[code ?? ''] ?? message));
  }
}
