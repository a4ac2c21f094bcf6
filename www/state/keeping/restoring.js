// @ts-check
/** A project out of the database, and back onto the page. */

import { failure } from '../../engine/protocol.js';
import { advance } from '../history.js';
import { rebased } from '../shared-lists.js';
import { sheetsOf } from '../sheets.js';
import { createStore } from '../store.js';
import { photosOf } from './snapshot.js';
import { checkedHistory, damaged, migrated } from './versions.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./database.js').PhotoRecord} PhotoRecord */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Video} Video */
/** @typedef {import('../history.js').History} History */

/**
 * A project in parts: `photos` are complete, `unread` are files that must be decoded again.
 * @typedef {{
 *   history: History, album: Map<string, Fact>, videos: Map<string, Video>, records: PhotoRecord[],
 *   unread: { id: string, file: File }[],
 * }} Content
 */

/**
 * @param {Database} database
 * @param {string} id
 * @returns {Promise<{ content: Content, stamp: string, created: number }>} rejects with `missing-project`,
 *   `damaged-project` or `newer-project`
 */
export async function readProject(database, id) {
  const [project, state] = await Promise.all([database.get('projects', id), database.get('states', id)]);
  if (!project || !state) throw failure('missing-project', 'There is no such project any more.');
  const kept = migrated(state);
  const history = { ...checkedHistory(kept.history), gesture: null };
  const all = database.transaction(['photos', 'facts']);
  const read = (/** @type {'photos' | 'facts'} */ table, /** @type {string[]} */ ids) => (
    Promise.all(ids.map((key) => /** @type {any} */ (all.objectStore(table)).get(key))).then((found) => found.filter(Boolean))
  );
  const fileKeys = kept.videos.map((/** @type {{ fileKey: string }} */ { fileKey }) => fileKey);
  const [records, facts, files] = await Promise.all([read('photos', kept.facts), read('facts', kept.facts), read('photos', fileKeys)]);
  return { content: contentOf(history, records, facts.map(({ fact }) => fact), kept.videos, files), stamp: project.stamp, created: project.created };
}

/**
 * @param {History} history
 * @param {PhotoRecord[]} records
 * @param {Fact[]} facts
 * @param {import('./database.js').KeptVideo[]} videos
 * @param {PhotoRecord[]} files of the videos
 * @returns {Content}
 */
function contentOf(history, records, facts, videos, files) {
  const whole = records.filter(({ work, small }) => work && small);
  const unread = records.flatMap(({ id, name, file, work }) => (!work && file ? { id, file: asFile(file, name) } : []));
  const there = new Set([...whole, ...unread].map(({ id }) => id));
  const album = new Map(facts.filter(({ id }) => there.has(id)).map((fact) => [fact.id, fact]));
  const missing = [...photosOf(history)].filter((id) => !album.has(id));
  const byKey = new Map(files.map((record) => [record.id, record.file]));
  const known = videos.flatMap(({ fileKey, ...video }) => {
    const file = byKey.get(fileKey);
    return file ? { ...video, file: asFile(file, video.name) } : [];
  });
  return {
    history: missing.length > 0 ? advance(history, { type: 'forget-photos', ids: missing }) : history,
    album,
    videos: new Map(known.map((video) => [video.key, video])),
    records: [...whole, ...files],
    unread,
  };
}

/**
 * Shows a project to nobody: in a store beside the page's, all that the page will ask for is worked out.
 * @param {Content} content
 * @param {{ planner: import('../store.js').Planner, shared: Partial<import('../shared-lists.js').SharedLists> }} app `shared`: the
 *   lists that all projects have in common
 * @returns {Content} with these lists; throws what the page would
 */
export function rehearsed(content, { planner, shared }) {
  for (const { page } of sheetsOf(content.history.present)) if (!isDrawable(page, planner)) throw damaged('page: cannot be drawn');
  const whole = { ...content, history: rebased(content.history, shared) };
  const stage = createStore();
  stage.planner.value = planner;
  stage.load(whole);
  for (const part of [stage.photos, stage.layouts, stage.layoutFacts, stage.geometry]) part.peek();
  return whole;
}

/**
 * Makes a project the one on the page; when that fails, everything is as it was.
 * @param {Content} content
 * @param {import('../place.js').Place} place where it is kept
 * @param {{ store: import('../store.js').Store, photos: ReturnType<typeof import('../../engine/photos.js').createPhotos> }} app
 */
export function exchanged({ history, album, videos, records }, place, { store, photos }) {
  const before = { history: store.history.peek(), album: store.album.peek(), videos: store.videos.peek(), place: store.place.peek() };
  /** @type {string[]} */
  const fresh = [];
  try {
    for (const { id, name, file, work, small } of records) {
      if (!work || !small || photos.has(id)) continue;
      // A file that could not be kept is missed by the export alone, which says so.
      photos.add(id, { name, file: file ?? new Blob(), work, small });
      fresh.push(id);
    }
    store.load({ history, album, videos, place });
  } catch (error) {
    store.load(before);
    fresh.forEach(photos.forget);
    throw error;
  }
  for (const id of before.album.keys()) if (!album.has(id)) photos.forget(id);
}

/**
 * @param {import('../project.js').PageDocument} page
 * @param {import('../store.js').Planner} planner
 */
export function isDrawable(page, planner) {
  try {
    return planner.geometry(page.layout, page.page).panels.length === page.panels.length;
  } catch {
    return false;
  }
}

/** @param {Blob} blob @param {string} name */
function asFile(blob, name) {
  return blob instanceof File ? blob : new File([blob], name, { type: blob.type });
}
