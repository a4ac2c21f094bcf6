// @ts-check
/**
 * What opening has in common whatever kind of file it is: one at a time, with progress, and what is opened is read and
 * checked in full before anything on the page changes. It becomes a project of its own.
 */

import { signal } from '@preact/signals';
import { Priority } from '../../engine/queue.js';
import { strings } from '../../strings.js';
import { freshPlace } from '../place.js';
import { takenBy } from './project-json.js';
import { placeholderOf } from './placeholder.js';
import { isDrawable } from './restoring.js';
import { damaged } from './versions.js';

/** @typedef {import('./project-json.js').FileProject} FileProject */
/** @typedef {import('./project-json.js').FilePhoto} FilePhoto */
/** @typedef {import('./restoring.js').Content} Content */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../messages.js').Way} Way */
/** @typedef {Awaited<ReturnType<typeof import('./archive.js').readArchive>>} Archive */
/** @typedef {ReturnType<typeof createFileOpening>} FileOpening */

/**
 * `take` reads a photo into the engine and makes its fact; all that it took is let go when the opening fails.
 * @typedef {{
 *   planner: import('../store.js').Planner, photos: (wanted: readonly FilePhoto[], archive: Archive) => Promise<Fact[]>,
 *   absent: (photo: FilePhoto, number: number) => Promise<Fact>,
 * }} Hands
 */

/**
 * @param {{
 *   engine: Pick<import('../../engine/engine.js').Engine, 'ready' | 'importPhoto' | 'forgetPhoto'>,
 *   messages: Pick<import('../messages.js').Messages, 'alert'>, opening: Pick<import('./opening.js').Opening, 'enter'>,
 * }} app
 */
export function createFileOpening({ engine, messages, opening }) {
  /** What is being read. @type {import('@preact/signals').Signal<{ name: string, done: number, total: number } | null>} */
  const progress = signal(null);
  /** @type {AbortController | null} */
  let stop = null;

  return { progress, open, cancel: () => stop?.abort() };

  /**
   * @param {File} file
   * @param {(hands: Hands) => Promise<Content>} read
   * @param {Way} [way] what else can be done with the file, where it cannot be opened
   * @returns {Promise<boolean>} whether it is on the page now
   */
  async function open(file, read, way) {
    if (stop) return false;
    stop = new AbortController();
    progress.value = { name: file.name, done: 0, total: 1 };
    /** Photos that are in the engine. @type {string[]} */
    const taken = [];
    const { signal: cancelled } = stop;
    const take = async (/** @type {string} */ id, /** @type {Blob} */ blob) => {
      const meta = await engine.importPhoto(id, blob, { priority: Priority.PAGE, signal: cancelled });
      taken.push(id);
      return meta;
    };
    try {
      const planner = await engine.ready;
      const content = await read({
        planner,
        photos: (wanted, archive) => readPhotos(wanted, archive, take),
        absent: (photo, number) => placeFor(photo, number, take),
      });
      cancelled.throwIfAborted();
      await opening.enter(freshPlace(), content, undefined, { join: true });
      return true;
    } catch (error) {
      taken.forEach(engine.forgetPhoto);
      const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
      if (code !== 'cancelled' && !cancelled.aborted) messages.alert(strings.projectFileNotOpened(file.name, strings.projectReasons[code ?? ''] ?? message), way);
      return false;
    } finally {
      stop = null;
      progress.value = null;
    }
  }

  /**
   * @param {readonly FilePhoto[]} photos
   * @param {Archive} archive
   * @param {(id: string, blob: Blob) => Promise<import('../../engine/protocol.js').Imported['meta']>} take
   * @returns {Promise<Fact[]>} those that can be read; the others are named
   */
  async function readPhotos(photos, archive, take) {
    const facts = await Promise.all(photos.map(async (photo) => {
      const { path, type, subjects, measured, rank: _rank, like, absent, ...fact } = photo;
      try {
        const found = archive.get(path);
        if (!found) throw damaged(`${path} is missing`);
        const meta = await take(fact.id, new File([await found.read()], fact.name, { type }));
        const known = { ...fact, meta: { ...meta, taken: takenBy(photo, meta.taken), subjects: subjects ?? [] } };
        if (absent && like) return keepsPlace(known, photo);
        return { ...known, measures: measured ? meta.measures : null, looked: subjects !== null };
      } catch (error) {
        const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
        if (code === 'cancelled') throw error;
        messages.alert(strings.fileFailed(fact.name, strings.reasons[code ?? ''] ?? message));
        return [];
      } finally {
        const now = progress.peek();
        if (now) progress.value = { ...now, done: now.done + 1, total: photos.length };
      }
    }));
    return facts.flat();
  }
}

/** Of a photo whose likeness is not told. */
const UNLIKE = { hash: '', fingerprint: '', width: 1500, height: 1000 };

/**
 * An empty frame in the place of a photo that is not here.
 * @param {FilePhoto} photo
 * @param {number} number from 1
 * @param {(id: string, blob: Blob) => Promise<import('../../engine/protocol.js').Imported['meta']>} take
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

/**
 * @param {FileProject} project
 * @param {import('../store.js').Planner} planner
 * @returns {FileProject} with pages, styles and layouts that the core takes
 */
export function checked(project, planner) {
  const { present, shown } = project.history;
  if (present.page && !isDrawable(present.page, planner)) throw damaged('present.page: cannot be drawn');
  const good = (/** @type {readonly any[]} */ list, /** @type {(json: string, name: string) => any} */ check) => list.flatMap((item) => {
    try {
      return [check(JSON.stringify(item), 'project.json')];
    } catch {
      return [];
    }
  });
  const lists = {
    mine: good(present.mine, planner.checkStyle), favourites: good(present.favourites, planner.checkStyle),
    ownLayouts: good(present.ownLayouts, planner.checkLayout),
  };
  const drawable = shown.filter(({ page }) => isDrawable(page, planner));
  return { ...project, history: { ...project.history, present: { ...present, ...lists }, shown: drawable } };
}
