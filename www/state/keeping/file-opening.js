// @ts-check
/**
 * What opening has in common whatever kind of file it is: one after the other, with progress, and what is opened is read and
 * checked in full before anything on the page changes. It becomes a project of its own.
 */

import { signal } from '@preact/signals';
import { PHOTOS_AT_ONCE, SILENCE } from '../../engine/limits.js';
import { patience } from '../../engine/patience.js';
import { cancelled as stopped, failure } from '../../engine/protocol.js';
import { Priority } from '../../engine/queue.js';
import { strings } from '../../strings.js';
import { freshPlace } from '../place.js';
import { takenBy } from './project-json.js';
import { UNLIKE, placeholderOf } from './placeholder.js';
import { damaged } from './versions.js';

/** @typedef {import('./project-json.js').FilePhoto} FilePhoto */
/** @typedef {import('./restoring.js').Content} Content */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../messages.js').Way} Way */
/** @typedef {Awaited<ReturnType<typeof import('./archive.js').readArchive>>} Archive */
/** @typedef {ReturnType<typeof createFileOpening>} FileOpening */

/** Reads a photo into the engine; all that it took is let go when the opening fails. @typedef {(id: string, blob: Blob) => Promise<import('../../engine/protocol.js').Imported['meta']>} Take */
/** A photo that could not be read. @typedef {{ name: string, why: string }} Failed */
/**
 * `watch` is told of whatever arrives, so that a file of which nothing comes is given up.
 * @typedef {{
 *   planner: import('../store.js').Planner, photos: (wanted: readonly FilePhoto[], archive: Archive) => Promise<Fact[]>,
 *   absent: (photo: FilePhoto, number: number) => Promise<Fact>, watch: Required<import('../../engine/inflate.js').Watch>,
 * }} Hands
 */

/**
 * @param {{
 *   engine: Pick<import('../../engine/engine.js').Engine, 'ready' | 'importPhoto' | 'forgetPhoto'>,
 *   messages: Pick<import('../messages.js').Messages, 'fileFailed' | 'alert'>, opening: Pick<import('./opening.js').Opening, 'enter'>,
 * }} app
 */
export function createFileOpening({ engine, messages, opening }) {
  /** What is being read. @type {import('@preact/signals').Signal<{ name: string, done: number, total: number } | null>} */
  const progress = signal(null);
  /** @type {AbortController | null} */
  let stop = null;
  /** The last of those that wait for each other. @type {Promise<unknown>} */
  let last = Promise.resolve();
  /** How often a person has stopped it. */
  let stops = 0;

  return { progress, open, cancel, stops: () => stops };

  /** Ends what is being read, and those that wait for it. */
  function cancel() {
    stops += 1;
    stop?.abort(stopped());
  }

  /**
   * @param {File} file
   * @param {(hands: Hands) => Promise<Content>} read
   * @param {Way} [way] what else can be done with the file, where it cannot be opened
   * @returns {Promise<boolean>} whether it is on the page now
   */
  function open(file, read, way) {
    const before = stops;
    const done = last.then(() => stops === before && openNow(file, read, way));
    last = done.catch(() => {});
    return done;
  }

  /** @param {File} file @param {(hands: Hands) => Promise<Content>} read @param {Way} [way] */
  async function openNow(file, read, way) {
    stop = new AbortController();
    progress.value = { name: file.name, done: 0, total: 1 };
    /** Photos that are in the engine. @type {string[]} */
    const taken = [];
    /** The others, which are named when the rest is open. @type {Failed[]} */
    const failed = [];
    const { signal: cancelled } = stop;
    const quiet = silence(stop);
    const watch = { signal: cancelled, beat: quiet.beat };
    /** @type {Take} */
    const take = async (id, blob) => {
      const meta = await engine.importPhoto(id, blob, { priority: Priority.PAGE, signal: cancelled });
      quiet.beat();
      taken.push(id);
      return meta;
    };
    try {
      const planner = await engine.ready;
      quiet.beat();
      const content = await Promise.race([quiet.over, read({
        planner, watch,
        photos: (wanted, archive) => readPhotos(wanted, archive, { take, watch, failed }),
        absent: (photo, number) => placeFor(photo, number, take),
      })]);
      cancelled.throwIfAborted();
      await opening.enter(freshPlace(), content, undefined, { join: true });
      if (content.dropped?.length) messages.alert(strings.partsLeftOut(file.name, content.dropped.length));
      for (const { name, why } of failed) messages.fileFailed(name, why);
      return true;
    } catch (error) {
      taken.forEach(engine.forgetPhoto);
      // What was stopped fails in many ways, for the one reason.
      const { code, message } = /** @type {{ code?: string, message: string }} */ (cancelled.aborted ? cancelled.reason : error);
      const why = strings.projectReasons[code ?? ''] ?? message;
      if (code !== 'cancelled') messages.fileFailed(file.name, why, { text: strings.projectFileNotOpened(file.name, why), way });
      return false;
    } finally {
      quiet.end();
      progress.value = null;
    }
  }

  /**
   * @param {readonly FilePhoto[]} photos
   * @param {Archive} archive
   * @param {{ take: Take, watch: Hands['watch'], failed: Failed[] }} how
   * @returns {Promise<Fact[]>} those that can be read; the others are named in `failed`
   */
  async function readPhotos(photos, archive, { take, watch, failed }) {
    // Thousands that are one file would be read thousands of times.
    if (new Set(photos.map(({ path }) => path)).size < photos.length) throw damaged('photos: two of them are one file');
    const packed = photos.some(({ path }) => archive.get(path)?.packed);
    // What has to be unpacked is held as a whole while it is read.
    const facts = await inTurns(photos, packed ? 1 : PHOTOS_AT_ONCE, async (photo) => {
      const { path, type, subjects, measured, rank: _rank, like, absent, ...fact } = photo;
      try {
        const found = archive.get(path);
        if (!found) throw damaged(`${path} is missing`);
        const meta = await take(fact.id, new File([await found.read(watch)], fact.name, { type }));
        const known = { ...fact, meta: { ...meta, taken: takenBy(photo, meta.taken), subjects: subjects ?? [] } };
        if (absent && like) return keepsPlace(known, photo);
        return { ...known, measures: measured ? meta.measures : null, looked: subjects !== null };
      } catch (error) {
        const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
        if (watch.signal.aborted || ['cancelled', 'too-large-project'].includes(code ?? '')) throw error;
        failed.push({ name: fact.name, why: strings.reasons[code ?? ''] ?? message });
        return [];
      } finally {
        const now = progress.peek();
        if (now && !watch.signal.aborted) progress.value = { ...now, done: now.done + 1, total: photos.length };
      }
    });
    return facts.flat();
  }
}

/**
 * @template T, R
 * @param {readonly T[]} list
 * @param {number} atOnce
 * @param {(item: T) => Promise<R>} work none is begun any more after one has failed
 * @returns {Promise<R[]>} in the order of the list
 */
async function inTurns(list, atOnce, work) {
  /** @type {R[]} */
  const done = Array(list.length);
  let next = 0;
  const runner = async () => {
    while (next < list.length) {
      const at = next;
      next += 1;
      done[at] = await work(list[at]).catch((error) => { next = list.length; throw error; });
    }
  };
  await Promise.all(Array.from({ length: atOnce }, runner));
  return done;
}

/**
 * Gives up what shows no sign of life for a minute.
 * @param {AbortController} stop
 * @returns {{ beat: () => void, over: Promise<never>, end: () => void }} `beat`: something came; `over` rejects when it is given up, or stopped
 */
function silence(stop) {
  let relax = () => {};
  let since = -Infinity;
  const beat = () => {
    // Pieces come in thousands; timers need not.
    if (performance.now() - since < SILENCE / 60) return;
    since = performance.now();
    relax();
    relax = patience(SILENCE, () => stop.abort(failure('silent-project', 'Nothing of it came for a minute.')));
  };
  /** @type {Promise<never>} */
  const over = new Promise((_, reject) => { stop.signal.addEventListener('abort', () => reject(stop.signal.reason), { once: true }); });
  // It is no failure of what has ended well.
  over.catch(() => {});
  return { beat, over, end: () => { relax(); since = Infinity; } };
}

/**
 * An empty frame in the place of a photo that is not here.
 * @param {FilePhoto} photo
 * @param {number} number from 1
 * @param {Take} take
 * @returns {Promise<Fact>}
 */
async function placeFor(photo, number, take) {
  const { id, credit, like } = photo;
  const name = strings.absentPhoto(number);
  const meta = await take(id, new File([await placeholderOf(like ?? UNLIKE)], name, { type: 'image/png' }));
  return keepsPlace({ id, name, credit, meta: { ...meta, taken: takenBy(photo, null) } }, { ...photo, like: like ?? UNLIKE });
}

/**
 * @param {Omit<Fact, 'meta' | 'measures'> & { meta: NonNullable<Fact['meta']> }} fact of the empty frame
 * @param {FilePhoto} photo
 * @returns {Fact} it is framed as the photo was, and compared with none
 */
function keepsPlace(fact, { like, subjects, measured }) {
  const { width, height, ...rest } = like ?? UNLIKE;
  const meta = { ...fact.meta, width, height, subjects: subjects ?? [] };
  return { ...fact, meta, measures: null, looked: true, absent: { width, height, ...rest, subjects, measured } };
}
