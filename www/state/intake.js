// @ts-check
/**
 * What becomes of a file: a photo of the album with its facts, or a message with the reason, and the count of both.
 */

import { batch } from '@preact/signals';
import { CROWD, Priority } from '../engine/queue.js';
import { freshId } from './fresh-id.js';
import { strings } from '../strings.js';
import { looksLike } from './keeping/identity.js';
import { emptyFrames } from './keeping/placeholder.js';

/** @typedef {import('./album.js').Fact} Fact */
/** @typedef {ReturnType<typeof createIntake>} Intake */

/** Milliseconds in which photos of a crowd are told of together: whatever depends on the album would else be computed and painted anew for each. */
const TOGETHER = 300;

/** @returns {string} what the ids of photos begin with, so that no other session of any browser has the same */
export function freshPhotoPrefix() {
  return `p${freshId(6)}-`;
}

/**
 * @param {{
 *   store: import('./store.js').Store, pages: Pick<import('./pages.js').Pages, 'refine'>,
 *   engine: Pick<import('../engine/engine.js').Engine, 'importPhoto'>, messages: Pick<import('./messages.js').Messages, 'fileFailed'>, prefix?: string,
 * }} app `prefix` begins the ids of photos
 */
export function createIntake({ store, pages, engine, messages, prefix = 'p' }) {
  let lastId = 0;
  /** @type {(() => void)[]} */
  let untold = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  return { freshIds, isShown, readPhoto, arrived, failed, leaveOut, count };

  /** @param {number} many @returns {string[]} */
  function freshIds(many) {
    return Array.from({ length: many }, () => `${prefix}${(lastId += 1)}`);
  }

  /** Whether a photo is on the page, where somebody waits for it. @param {string} id @returns {boolean} */
  function isShown(id) {
    return !!store.page.peek()?.panels.some((panel) => panel.photo === id);
  }

  /**
   * @param {string} id
   * @param {File} file
   * @param {AbortSignal} signal
   */
  async function readPhoto(id, file, signal) {
    store.originals.set(id, file);
    const priority = isShown(id) ? Priority.PAGE : Priority.REST;
    let last = false;
    let read = await engine.importPhoto(id, file, { priority, signal }).then((meta) => ({ meta }), (error) => ({ error }));
    if ('error' in read && store.album.peek().get(id)?.meta) {
      failed(file, read.error);
      read = await emptyFrame(id).then((meta) => ({ meta }), (error) => ({ error }));
    }
    await together(isShown(id), () => {
      try {
        if ('error' in read) throw read.error;
        arrived(id, read.meta);
      } catch (error) {
        failed(file, error);
      }
      store.originals.delete(id);
      leaveOut([id]);
      last = isLast();
      if (!last) count(1, 0);
    });
    if (!last) return;
    // What follows, when all are read, is as much work as showing the last of them: a task of its own.
    await new Promise((resolve) => { setTimeout(resolve); });
    count(1, 0);
  }

  /**
   * Of a photo that was read before, and now cannot be: its place on the pages is kept.
   * @param {string} id
   */
  async function emptyFrame(id) {
    const [{ fact, file }] = await emptyFrames([/** @type {Fact} */ (store.album.peek().get(id))]);
    const meta = await engine.importPhoto(id, file, { priority: isShown(id) ? Priority.PAGE : Priority.REST });
    store.know(fact);
    return meta;
  }

  /** Whether a photo is the last of many. */
  function isLast() {
    const { done, total } = progress();
    return total > CROWD && total - done === 1;
  }

  /**
   * @param {boolean} now whether somebody waits for it
   * @param {() => void} tell
   * @returns {Promise<void>} when it was told
   */
  function together(now, tell) {
    const { done, total } = progress();
    return new Promise((resolve) => {
      untold.push(() => { tell(); resolve(); });
      if (now || total - done <= CROWD) tellAll();
      else timer ??= setTimeout(tellAll, TOGETHER);
    });
  }

  function tellAll() {
    clearTimeout(timer);
    timer = undefined;
    const all = untold;
    untold = [];
    batch(() => all.forEach((tell) => tell()));
  }

  /**
   * @param {string} id
   * @param {import('../engine/protocol.js').Imported['meta']} meta
   * @param {Partial<Fact>} [more]
   */
  function arrived(id, meta, more) {
    const fact = store.album.peek().get(id);
    // A frame of a film that nobody wants any more.
    if (!fact) return;
    store.know({ ...fact, ...knownOf(fact, meta), ...more });
    if (isShown(id)) pages.refine();
  }

  /**
   * @param {Fact} fact
   * @param {import('../engine/protocol.js').Imported['meta']} meta
   * @returns {Partial<Fact>}
   */
  function knownOf({ meta: before, absent }, meta) {
    if (absent) {
      const { width, height, subjects, measured } = absent;
      // The photo itself turned up, or else it is the frame that keeps its place, and is compared with none.
      if (looksLike(meta, absent)) return { meta: { ...meta, subjects: subjects ?? [] }, measures: measured ? meta.measures : null, looked: subjects !== null, absent: undefined };
      return { meta: { ...meta, width, height, taken: before?.taken ?? null, subjects: subjects ?? [] }, measures: null };
    }
    // A photo that is read again keeps what was found in it.
    return before ? { meta: { ...meta, subjects: before.subjects } } : { meta, measures: meta.measures };
  }

  /** @param {File} file @param {unknown} error */
  function failed(file, error) {
    const { code, message } = /** @type {{ code: string, message: string }} */ (error);
    if (code !== 'cancelled') messages.fileFailed(file.name, strings.reasons[code] ?? message);
  }

  /**
   * Forgets those of some photos that did not come.
   * @param {readonly string[]} ids
   * @returns {string[]} the others
   */
  function leaveOut(ids) {
    const missing = ids.filter((id) => !store.album.peek().get(id)?.meta);
    if (missing.length > 0) store.change({ type: 'forget-photos', ids: missing });
    return ids.filter((id) => !missing.includes(id));
  }

  function progress() {
    return store.reading.peek() ?? { done: 0, total: 0 };
  }

  /**
   * @param {number} done
   * @param {number} more
   */
  function count(done, more) {
    const before = progress();
    const now = { done: before.done + done, total: before.total + more };
    store.reading.value = now.done < now.total ? now : null;
  }
}
