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
import { drawnOnce, exchanged, rehearsed } from './rehearsing.js';
import { beginningWith, drawnOf, holdPhotos, isThere, nameOf, readProject, readState } from './restoring.js';

/** @typedef {import('./restoring.js').Content} Content */
/** @typedef {import('../place.js').Place} Place */
/** @typedef {ReturnType<typeof createOpening>} Opening */

/** A page that is loaded again waits so long for its former self to let go, in ms. */
const PATIENCE = 2_000;

/**
 * A project that cannot be shown. `why` is a key of the reasons in `strings`, `detail` the place of the fault; `back`:
 * there are states of it to go back to.
 * @typedef {{ id: string, name: string, why: string, detail: string, back: boolean }} Broken
 */
/**
 * `drawn` waits until the views have drawn what is in the store and rejects where they cannot; `retry` has them try again.
 * @typedef {{ drawn: () => Promise<void>, retry: () => void }} Views
 */

/** Reasons that are not the project's. */
const OUTSIDE = new Set(['not-saved', 'missing-project', 'no-storage']);

/** @param {unknown} error */
function isOutside(error) {
  return OUTSIDE.has(/** @type {{ code: string }} */ (error).code);
}

/**
 * @param {{
 *   store: import('../store.js').Store, reading: Pick<import('../reading.js').Reading, 'resume'>,
 *   engine: Pick<import('../../engine/engine.js').Engine, 'ready' | 'photos' | 'renderPage'>, shelves: Pick<import('./shelves.js').Shelves, 'lists'>,
 *   saving: import('./saving.js').Saving, records: import('./photo-records.js').PhotoRecords, locks: import('./locks.js').Locks,
 *   messages: Pick<import('../messages.js').Messages, 'alert' | 'note'>, database: () => Promise<import('./database.js').Database>,
 *   journal: Pick<import('./journal.js').Journal, 'recall' | 'names'>, last: ReturnType<typeof import('./last-project.js').createLastProject>,
 *   drawnStates: import('./drawn-states.js').DrawnStates, leave: () => void, views?: Views,
 *   onMissing: (photos: readonly { id: string, name: string }[]) => void, onUnwritten: (names: readonly string[]) => void,
 * }} app `leave` closes what belongs to the project before; `onMissing`: photos of a project that was opened are not here;
 *   `onUnwritten`: photos of a project of which nothing was written
 */
export function createOpening({
  store, reading, engine, shelves, saving, records, locks, messages, database, journal, last, drawnStates, leave, onMissing, onUnwritten,
  views = { retry: () => {}, drawn: async () => {} },
}) {
  /** The project that another tab has open. @type {import('@preact/signals').Signal<{ id: string, name: string, follows: boolean } | null>} */
  const elsewhere = signal(null);
  /** @type {import('@preact/signals').Signal<Broken | null>} */
  const broken = signal(null);
  const first = last.recall();
  /** Whether the project of the last visit is still on its way. */
  const running = signal(first !== null);
  /** Those that are about to take the place of this one. */
  const turns = signal(0);
  const turning = computed(() => turns.value > 0);
  /** Photos on their way belong to the project that is there. */
  const busy = computed(() => store.reading.value !== null || store.fetching.value);
  let release = () => {};
  let trying = false;
  /** Ends the waiting for a project that another tab has. */
  let waiting = new AbortController();
  /** One after the other. @type {Promise<unknown>} */
  let queue = Promise.resolve();
  /** States that were gone back to in vain, of the project that is broken. @type {Set<string>} */
  const vain = new Set();

  return {
    elsewhere, broken, running, turning, busy, current: computed(() => store.place.value.id),
    begin, open, create, enter, goOnAsCopy, goBack, failedToShow, say,
  };

  /** Opens what this tab had open, or else what was open last. */
  async function begin() {
    try {
      release = await lockOf(store.place.peek());
      if (first) await openLast(first);
      else last.opened(store.place.peek().id);
    } catch (error) {
      say(error);
    } finally {
      running.value = false;
    }
  }

  /** @param {{ id: string, here: boolean }} last */
  async function openLast({ id, here }) {
    const base = await database();
    if (!await isThere(base, id)) {
      if (here && !await base.get('projects', id)) onUnwritten(journal.names(id));
      return last.opened(store.place.peek().id);
    }
    const free = await locks.take(projectLock(id), here ? PATIENCE : 0);
    if (free) return load(id, free);
    last.opened(store.place.peek().id);
    elsewhere.value = { id, name: await nameOf(base, id), follows: true };
    void follow(id);
  }

  /** Opens a project when the tab that has it lets go, unless something was begun here meanwhile. @param {string} id */
  async function follow(id) {
    const { signal: stop } = waiting;
    const free = await locks.wait(projectLock(id), stop).catch(() => null);
    if (!free) return;
    if (elsewhere.peek()?.id !== id || store.tray.peek().length > 0) free();
    else await load(id, free).catch(say);
  }

  /**
   * @param {string} id
   * @returns {Promise<boolean>} whether it is the one on the page now
   */
  async function open(id) {
    if (id === store.place.peek().id) return true;
    turns.value += 1;
    return openNow(id).finally(() => { turns.value -= 1; });
  }

  /** @param {string} id */
  async function openNow(id) {
    const free = await locks.take(projectLock(id));
    if (!free) {
      elsewhere.value = { id, name: await nameOf(await database(), id), follows: false };
      return false;
    }
    try {
      await load(id, free);
      return id === store.place.peek().id;
    } catch (error) {
      say(error);
      return false;
    }
  }

  /**
   * One that cannot be shown is told so; what is on the page stays.
   * @param {string} id
   * @param {() => void} free lets go of its lock
   */
  async function load(id, free) {
    const base = await database();
    try {
      const found = await readProject(base, id, engine.ready, journal.recall);
      await arrive(found, free).catch(async (error) => {
        // What the journal tells may be what cannot be shown.
        if (!found.place.stored || isOutside(error)) throw error;
        await arrive(await readProject(base, id, engine.ready), free);
      });
    } catch (error) {
      free();
      if (isOutside(error)) throw error;
      await holdPhotos(base, id).catch(() => {});
      const back = (await drawnOf(base, id, engine.ready).catch(() => [])).length > 0;
      breaks({ id, name: await nameOf(base, id), back }, error);
    }
  }

  /** @param {Awaited<ReturnType<typeof readProject>>} found @param {() => void} free */
  async function arrive({ place, content, drawn }, free) {
    await enter(place, content, free);
    drawnStates.know(place, drawn);
    records.know(content.records);
    if (content.missing?.length) onMissing(content.missing);
    if (content.filmless?.length) messages.alert(strings.filmsNotHere(content.filmless));
    if (content.dropped?.length) {
      await database().then((base) => holdPhotos(base, place.id)).catch(() => {});
      messages.alert(strings.partsLeftOut(store.project.peek().name || strings.untitled, content.dropped.length));
    }
    void reading.resume(content.unread, content.films);
  }

  /** @param {Pick<Broken, 'id' | 'name' | 'back'>} project @param {unknown} error */
  function breaks(project, error) {
    const { code, message } = /** @type {{ code?: unknown, message: string }} */ (error);
    vain.clear();
    broken.value = { ...project, why: typeof code === 'string' ? code : '', detail: message };
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
   * @param {() => void} [free] lets go of its lock, where it is held already; whoever took it has it still when this fails
   * @param {{ join?: boolean }} [how] `join`: its styles and layouts are added to those of this browser
   * @returns {Promise<void>}
   */
  function enter(next, content, free, how) {
    const turn = queue.then(() => enterNow(next, content, free, how));
    queue = turn.catch(() => {});
    return turn;
  }

  /** @type {typeof enter} */
  async function enterNow(next, content, free, { join = false } = {}) {
    const planner = await engine.ready;
    await allRead();
    const lock = free ?? await lockOf(next);
    turns.value += 1;
    try {
      const shared = join ? joined(content.history.present, shelves.lists()) : shelves.lists();
      const whole = rehearsed(content, { planner, shared });
      // Where nothing is lost, nobody need wait for it.
      if (store.tray.peek().length > 0) await drawnOnce(whole, engine);
      await saving.flush();
      if (next.id !== store.place.peek().id && !saving.isSafe()) throw failure('not-saved', 'This project is not saved.');
      await saving.during(() => shown(whole, next));
    } catch (error) {
      if (!free) lock();
      throw error;
    } finally {
      turns.value -= 1;
    }
    arrived(next, lock);
    leave();
  }

  /** @param {Content} content @param {Place} next */
  async function shown(content, next) {
    const turn = exchanged(content, next, { store, photos: engine.photos });
    trying = true;
    try {
      views.retry();
      await views.drawn();
      turn.settle();
    } catch (error) {
      turn.takeBack();
      views.retry();
      throw error;
    } finally {
      trying = false;
    }
  }

  /** What is on the page goes on as a project of its own; the one that it was stays as it is. */
  async function goOnAsCopy() {
    const next = freshPlace();
    const lock = await lockOf(next);
    const [history, album, videos] = [store.history.peek(), store.album.peek(), store.videos.peek()];
    store.load({ history, album, videos, place: next });
    arrived(next, lock);
  }

  /** The views cannot draw what is on the page. @param {unknown} error */
  function failedToShow(error) {
    // The one that is tried is taken back.
    if (trying) return;
    const place = store.place.peek();
    breaks({ id: place.id, name: store.project.peek().name, back: drawnStates.of(place).length > 0 }, error);
  }

  /**
   * Opens the last state of the broken project that was drawn and can be again.
   * @returns {Promise<boolean>} whether one is on the page now
   */
  async function goBack() {
    const project = broken.peek();
    if (!project) return false;
    const here = project.id === store.place.peek().id;
    try {
      const free = here ? release : await locks.take(projectLock(project.id), PATIENCE);
      if (!free) {
        elsewhere.value = { id: project.id, name: project.name, follows: false };
        return false;
      }
      const done = await (here ? goBackHere(free) : goBackTo(project.id, free));
      if (done) messages.note(strings.wentBack(project.name || strings.untitled));
      else broken.value = { ...project, back: false };
      if (!done && !here) free();
      return done;
    } catch (error) {
      say(error);
      return false;
    }
  }

  /** @param {() => void} free */
  async function goBackHere(free) {
    const place = store.place.peek();
    const [album, videos] = [store.album.peek(), store.videos.peek()];
    return tried(drawnStates.of(place), async (state) => {
      await enter(place, { history: beginningWith(state), album, videos, records: [], unread: [] }, free);
    });
  }

  /** @param {string} id @param {() => void} free */
  async function goBackTo(id, free) {
    const base = await database();
    const states = await drawnOf(base, id, engine.ready);
    return tried(states, async (state) => {
      await arrive({ ...await readState(base, id, state), drawn: [...states] }, free);
      // What the database has is the state that cannot be shown.
      store.load({ history: { ...store.history.peek() }, album: store.album.peek(), videos: store.videos.peek() });
    });
  }

  /**
   * @param {readonly import('../project.js').Project[]} states the last drawn at the end
   * @param {(state: import('../project.js').Project) => Promise<void>} attempt
   */
  async function tried(states, attempt) {
    for (const state of states.toReversed()) {
      const essence = JSON.stringify(state);
      if (vain.has(essence)) continue;
      vain.add(essence);
      try {
        await attempt(state);
        return true;
      } catch (error) {
        if (isOutside(error)) throw error;
      }
    }
    return false;
  }

  /** Photos on their way arrive first. @returns {Promise<void>} */
  function allRead() {
    return new Promise((resolve) => {
      const stop = effect(() => {
        if (!busy.value) queueMicrotask(() => { stop(); resolve(); });
      });
    });
  }

  /** @param {Place} place */
  async function lockOf({ id }) {
    return await locks.take(projectLock(id)) ?? (() => {});
  }

  /** @param {Place} place @param {() => void} lock */
  function arrived(place, lock) {
    if (release !== lock) release();
    release = lock;
    waiting.abort();
    waiting = new AbortController();
    elsewhere.value = null;
    broken.value = null;
    last.opened(place.id);
  }

  /** @param {unknown} error */
  function say(error) {
    const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
    messages.alert(strings.projectNotOpened(strings.projectReasons[code ?? ''] ?? message));
  }
}
