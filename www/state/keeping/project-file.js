// @ts-check
/**
 * A project as one file: a ZIP of `project.json` and the files of its photos and videos, with every pixel that they had
 * but without what cameras write beside them.
 */

import { PLACES_FOR_LOST, TEXT } from '../../engine/limits.js';
import { strings } from '../../strings.js';
import { advance } from '../history.js';
import { sheetsOf } from '../sheets.js';
import { save as saveFile } from '../files.js';
import { archiveOf, readArchive } from './archive.js';
import { strippedOf } from './identity.js';
import { projectJson, readProjectJson } from './project-json.js';
import { photosOf, snapshotOf } from './snapshot.js';
import { damaged } from './versions.js';

/** @typedef {import('./project-json.js').FileProject} FileProject */
/** @typedef {ReturnType<typeof createProjectFiles>} ProjectFiles */

export const EXTENSION = '.inkpanel';

/** @param {{ name: string }} file */
export function isProjectFile({ name }) {
  return name.toLowerCase().endsWith(EXTENSION);
}

/**
 * @param {{
 *   store: import('../store.js').Store, engine: Pick<import('../../engine/engine.js').Engine, 'photos'>,
 *   messages: Pick<import('../messages.js').Messages, 'alert' | 'note'>, saving: Pick<import('./saving.js').Saving, 'filed'>,
 *   fileOpening: import('./file-opening.js').FileOpening,
 * }} app
 */
export function createProjectFiles({ store, engine, messages, saving, fileOpening }) {
  return { save, open };

  /** Gives the project to the person as a file. */
  async function save() {
    try {
      const { file, name, unclean } = await packed();
      saveFile(file, name);
      saving.filed();
      messages.note(strings.projectSaved(unclean));
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
    for (const { key, file } of videos) blobs.set(videoKey(key), file);
    return packedProject({ history, facts: read, videos }, blobs);
  }

  /** Opens a project file beside those that there are. @param {File} file */
  function open(file) {
    return fileOpening.open(file, async ({ planner, photos: read, absent, watch }) => {
      const archive = await readArchive(file);
      const text = await archive.get('project.json')?.read({ most: TEXT.project, ...watch });
      if (!text) throw damaged('project.json is missing');
      const project = readProjectJson(await text.text(), planner);
      const films = project.videos.map(({ path }) => path);
      if (new Set(films).size < films.length) throw damaged('videos: two of them are one file');
      const facts = await read(project.photos, archive);
      if (facts.length === 0 && project.photos.length > 0) throw damaged('none of its photos can be read');
      const videos = await readVideos(project, archive, watch);
      const { name } = project.history.present;
      const { history, waiting } = withoutLost({ ...project.history, gesture: null }, facts);
      for (const [i, id] of waiting.entries()) {
        const told = project.photos.find((photo) => photo.id === id);
        const frame = await absent(told ?? unknown(id), i + 1);
        facts.push(told ? { ...frame, name: told.name } : frame);
      }
      const present = { ...history.present, name: name || file.name.slice(0, -EXTENSION.length) };
      return {
        history: { ...history, present }, album: new Map(facts.map((fact) => [fact.id, fact])),
        videos: new Map(videos.map((video) => [video.key, video])), records: [], unread: [], dropped: project.dropped,
      };
    });
  }
}

/** @param {string} key of a video, which is no id of a photo */
export function videoKey(key) {
  return `video ${key}`;
}

/**
 * @param {Pick<import('./snapshot.js').Snapshot, 'history' | 'facts' | 'videos'>} project
 * @param {ReadonlyMap<string, Blob>} blobs the files of its photos, by their ids, and of its videos
 * @param {number} [version] of the history
 * @returns {Promise<{ file: Blob, name: string, unclean: string[] }>} `unclean`: files whose place and date could not be taken out
 */
export async function packedProject({ history, facts, videos }, blobs, version) {
  const { json, paths } = projectJson(history, facts.map((fact) => ({ ...fact, type: blobs.get(fact.id)?.type ?? '' })), videos, version);
  /** @type {string[]} */
  const unclean = [];
  const entries = [];
  for (const [id, name] of paths) {
    const { blob, clean } = await strippedOf(/** @type {Blob} */ (blobs.get(id)));
    if (!clean) unclean.push(facts.find((fact) => fact.id === id)?.name ?? videos.find(({ key }) => videoKey(key) === id)?.name ?? name);
    entries.push({ name, blob });
  }
  const file = await archiveOf([{ name: 'project.json', blob: new Blob([json]) }, ...entries]);
  return { file: new Blob([file], { type: 'application/zip' }), name: fileNameOf(history.present.name), unclean };
}

/** @param {string} name of a project */
export function fileNameOf(name) {
  return `${(name || strings.untitled).replaceAll(/[^\p{L}\p{N} ._-]+/gu, '-').slice(0, 80)}${EXTENSION}`;
}

/**
 * Photos on pages that are not in the file keep their places, as they may come back; thousands that never were have none.
 * @param {import('../history.js').History} history
 * @param {readonly import('../album.js').Fact[]} facts of the photos that are there
 * @returns {{ history: import('../history.js').History, waiting: string[] }} `waiting`: the photos whose places are kept
 */
function withoutLost(history, facts) {
  const here = new Set(facts.map(({ id }) => id));
  const lost = [...photosOf(history)].filter((id) => !here.has(id));
  const shown = new Set(sheetsOf(history.present).flatMap(({ page }) => page.panels.map(({ photo }) => photo)));
  const waits = new Set(lost.filter((id) => shown.has(id)).slice(0, PLACES_FOR_LOST));
  const gone = new Set(lost.filter((id) => !waits.has(id)));
  if (gone.size === 0) return { history, waiting: [...waits] };
  const { present, shown: before, ...rest } = advance(history, { type: 'forget-photos', ids: [...gone] });
  /** @type {<T extends { page: import('../project.js').PageDocument }>(one: T) => T} */
  const without = (one) => ({ ...one, page: pageWithout(one.page, gone) });
  const page = present.page && pageWithout(present.page, gone);
  const whole = { ...rest, present: { ...present, page, others: present.others.map(without) }, shown: before.map(without) };
  return { history: whole, waiting: [...waits] };
}

/** @param {string} id @returns {import('./project-json.js').FilePhoto} of a photo of which nothing is told */
function unknown(id) {
  return { id, name: id, path: '', type: '', subjects: null, measured: true, rank: null, like: null, absent: true };
}

/** @param {import('../project.js').PageDocument} page @param {ReadonlySet<string>} gone photos */
function pageWithout(page, gone) {
  const panels = page.panels.map((panel) => (gone.has(panel.photo ?? '') ? { ...panel, photo: null } : panel));
  return { ...page, panels, order: page.order.filter((id) => !gone.has(id)) };
}

/**
 * @param {FileProject} project
 * @param {import('./file-opening.js').Archive} archive
 * @param {import('./file-opening.js').Hands['watch']} watch
 */
async function readVideos({ videos }, archive, watch) {
  const read = [];
  for (const { path, type, ...video } of videos) {
    // Without its video a frame is a photo like others.
    const blob = await archive.get(path)?.read(watch).catch((error) => {
      if (error.code !== 'damaged-project') throw error;
      return null;
    });
    if (blob) read.push({ ...video, file: new File([blob], video.name, { type }) });
  }
  return read;
}
