// @ts-check
/**
 * A project that cannot be shown, as a file all the same: its photos, and of its document whatever there is, for an
 * Inkpanel that can read it or for whoever wants to look.
 */

import { archiveOf } from './archive.js';
import { strippedOf } from './identity.js';
import { fileNameOf, packedProject, videoKey } from './project-file.js';
import { nameOf } from './restoring.js';

/**
 * @param {import('./database.js').Database} database
 * @param {string} id
 * @returns {Promise<{ file: Blob, name: string, unclean: string[] }>}
 */
export async function rescued(database, id) {
  const [project, state, name] = await Promise.all([database.get('projects', id), /** @type {Promise<any>} */ (database.get('states', id)), nameOf(database, id)]);
  const videos = listOf(state?.videos);
  const keys = new Set([project?.held, project?.refs, state?.facts, videos.map((video) => video?.fileKey)].flatMap(listOf).filter((key) => typeof key === 'string'));
  const records = (await Promise.all([...keys].map((key) => database.get('photos', key)))).filter((record) => record?.file instanceof Blob);
  const files = new Map(records.map((record) => /** @type {const} */ ([String(record?.id), /** @type {Blob} */ (record?.file)])));
  try {
    const facts = (await Promise.all(listOf(state.facts).map((key) => database.get('facts', key)))).flatMap((record) => (record && files.has(record.id) ? [record.fact] : []));
    const films = videos.flatMap(({ fileKey, ...video }) => (files.has(fileKey) ? [{ ...video, file: files.get(fileKey) }] : []));
    const blobs = new Map([...files, ...films.map(({ key, file }) => /** @type {const} */ ([videoKey(key), file]))]);
    return { ...await packedProject({ history: state.history, facts, videos: films }, blobs, state.version), name: fileNameOf(name) };
  } catch {
    // Not even its parts are what they should be.
    const entries = [{ name: 'project.json', blob: new Blob([textOf({ format: 'inkpanel', project, state })]) }];
    for (const [i, record] of records.entries()) {
      const { blob } = await strippedOf(/** @type {Blob} */ (record?.file));
      entries.push({ name: `photos/${String(i + 1).padStart(3, '0')}-${String(record?.name).replaceAll(/[^\p{L}\p{N}._-]+/gu, '-').slice(-60)}`, blob });
    }
    return { file: new Blob([await archiveOf(entries)], { type: 'application/zip' }), name: fileNameOf(name), unclean: [] };
  }
}

/** @param {unknown} value @returns {any[]} */
function listOf(value) {
  return Array.isArray(value) ? value : [];
}

/** @param {unknown} value @returns {string} as much of it as JSON can tell */
function textOf(value) {
  try {
    return JSON.stringify(value, (_, part) => (typeof part === 'bigint' || part instanceof Map || part instanceof Set ? String(part) : part), 1);
  } catch {
    return String(value);
  }
}
