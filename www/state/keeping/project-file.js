// @ts-check
/**
 * A project as one file: a ZIP of `project.json` and the original files of its photos and videos. What is opened is
 * read and checked in full before anything on the page changes, and becomes a project of its own.
 */

import { signal } from '@preact/signals';
import { Priority } from '../../engine/queue.js';
import { strings } from '../../strings.js';
import { save as saveFile } from '../files.js';
import { archiveOf, readArchive } from './archive.js';
import { freshPlace } from './opening.js';
import { parsedProject, projectJson, withFreshIds } from './project-json.js';
import { isDrawable } from './restoring.js';
import { snapshotOf } from './snapshot.js';
import { damaged } from './versions.js';

/** @typedef {import('./project-json.js').FileProject} FileProject */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {ReturnType<typeof createProjectFiles>} ProjectFiles */

export const EXTENSION = '.inkpanel';
/** Characters of `project.json`: a thousand pages take a tenth of it. */
const LONGEST = 64 * 2 ** 20;

/** @param {{ name: string }} file */
export function isProjectFile({ name }) {
  return name.toLowerCase().endsWith(EXTENSION);
}

/**
 * @param {{
 *   store: import('../store.js').Store, engine: Pick<import('../../engine/engine.js').Engine, 'ready' | 'importPhoto' | 'forgetPhoto' | 'photos'>,
 *   messages: Pick<import('../messages.js').Messages, 'alert' | 'note'>, saving: Pick<import('./saving.js').Saving, 'filed'>,
 *   opening: Pick<import('./opening.js').Opening, 'enter'>,
 * }} app
 */
export function createProjectFiles({ store, engine, messages, saving, opening }) {
  /** What is being written or read. @type {import('@preact/signals').Signal<{ name: string, done: number, total: number } | null>} */
  const progress = signal(null);
  /** @type {AbortController | null} */
  let stop = null;

  return { progress, save, open, cancel: () => stop?.abort() };

  /** Gives the project to the person as a file. */
  async function save() {
    try {
      const { file, name } = await packed();
      saveFile(file, name);
      saving.filed();
      messages.note(strings.projectSaved);
    } catch (error) {
      messages.alert(strings.projectNotSaved(/** @type {Error} */ (error).message));
    }
  }

  async function packed() {
    const { history, facts, videos } = snapshotOf(store);
    const read = facts.filter(({ id }) => engine.photos.has(id));
    /** @type {Map<string, Blob>} */
    const blobs = new Map();
    for (const { id } of read) blobs.set(id, engine.photos.get(id).file);
    for (const { key, file } of videos) blobs.set(`video ${key}`, file);
    const { json, paths } = projectJson(history, read.map((fact) => ({ ...fact, type: blobs.get(fact.id)?.type ?? '' })), videos);
    const entries = [...paths].map(([id, name]) => ({ name, blob: /** @type {Blob} */ (blobs.get(id)) }));
    const file = await archiveOf([{ name: 'project.json', blob: new Blob([json]) }, ...entries]);
    const plain = (history.present.name || strings.untitled).replaceAll(/[^\p{L}\p{N} ._-]+/gu, '-').slice(0, 80);
    return { file: new Blob([file], { type: 'application/zip' }), name: `${plain}${EXTENSION}` };
  }

  /** Opens a project file beside those that there are. @param {File} file */
  async function open(file) {
    if (stop) return;
    stop = new AbortController();
    progress.value = { name: file.name, done: 0, total: 1 };
    /** @type {string[]} */
    const taken = [];
    try {
      const planner = await engine.ready;
      const archive = await readArchive(file);
      const text = await archive.get('project.json')?.read();
      if (!text || text.size > LONGEST) throw damaged('project.json is missing');
      const project = withFreshIds(checked(parsedProject(await text.text()), planner));
      const facts = await readPhotos(project, archive, taken, stop.signal);
      if (facts.length === 0 && project.photos.length > 0) throw damaged('none of its photos can be read');
      const videos = await readVideos(project, archive);
      const { name } = project.history.present;
      const present = { ...project.history.present, name: name || file.name.slice(0, -EXTENSION.length) };
      const content = {
        history: { ...project.history, present, gesture: null }, album: new Map(facts.map((fact) => [fact.id, fact])),
        videos: new Map(videos.map((video) => [video.key, video])), records: [], unread: [],
      };
      await opening.enter(freshPlace(), content, undefined, { join: true });
    } catch (error) {
      taken.forEach(engine.forgetPhoto);
      const { code, message } = /** @type {{ code?: string, message: string }} */ (error);
      if (code !== 'cancelled') messages.alert(strings.projectFileNotOpened(file.name, strings.projectReasons[code ?? ''] ?? message));
    } finally {
      stop = null;
      progress.value = null;
    }
  }

  /**
   * @param {FileProject} project
   * @param {Awaited<ReturnType<typeof readArchive>>} archive
   * @param {string[]} taken ids of the photos that are in the engine
   * @param {AbortSignal} signal
   * @returns {Promise<Fact[]>}
   */
  async function readPhotos({ photos }, archive, taken, signal) {
    const facts = await Promise.all(photos.map(async ({ path, type, subjects, measured, ...fact }) => {
      try {
        const found = archive.get(path);
        if (!found) throw damaged(`${path} is missing`);
        const file = new File([await found.read()], fact.name, { type });
        const meta = await engine.importPhoto(fact.id, file, { priority: Priority.PAGE, signal });
        taken.push(fact.id);
        return { ...fact, meta: { ...meta, subjects: subjects ?? [] }, measures: measured ? meta.measures : null, looked: subjects !== null };
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

  /**
   * @param {FileProject} project
   * @param {Awaited<ReturnType<typeof readArchive>>} archive
   */
  async function readVideos({ videos }, archive) {
    const read = await Promise.all(videos.map(async ({ path, type, ...video }) => {
      // Without its video a frame is a photo like others.
      const blob = await archive.get(path)?.read().catch(() => null);
      return blob ? [{ ...video, file: new File([blob], video.name, { type }) }] : [];
    }));
    return read.flat();
  }
}

/**
 * @param {FileProject} project
 * @param {import('../store.js').Planner} planner
 * @returns {FileProject} with pages, styles and layouts that the core takes
 */
function checked(project, planner) {
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
