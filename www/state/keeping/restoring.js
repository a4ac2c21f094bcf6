// @ts-check
/** A project out of the database, and back onto the page. */

import { failure } from '../../engine/protocol.js';
import { strings } from '../../strings.js';
import { rebased } from '../shared-lists.js';
import { sheetsOf } from '../sheets.js';
import { createStore } from '../store.js';
import { emptyFrames } from './placeholder.js';
import { photosOf } from './snapshot.js';
import { checkedHistory, damaged, migrated } from './versions.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./database.js').PhotoRecord} PhotoRecord */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Video} Video */
/** @typedef {import('../history.js').History} History */

/**
 * A project in parts: `records` are what the database has of its photos, `unread` files that must be decoded again, `films`
 * the keys of videos whose frames must be; `missing` are the photos in the tray for which an empty frame stands, `filmless`
 * the names of videos that left nothing but their frames.
 * @typedef {{
 *   history: History, album: Map<string, Fact>, videos: Map<string, Video>, records: PhotoRecord[],
 *   unread: { id: string, file: File }[], films?: string[], missing?: { id: string, name: string }[], filmless?: string[],
 * }} Content
 */

/**
 * @param {Database} database
 * @param {string} id
 * @param {(id: string, base: import('./journal.js').Base) => import('./journal.js').Told | null} [recall] what the journal
 *   tells of edits that are not in the database
 * @returns {Promise<{ content: Content, stamp: string, created: number, stored?: import('./database.js').KeptHistory }>} `stored` is
 *   what the database has, where the journal told of more; rejects with `missing-project`, `damaged-project` or `newer-project`
 */
export async function readProject(database, id, recall = () => null) {
  const [project, state] = await Promise.all([database.get('projects', id), database.get('states', id)]);
  if (!project || !state) throw failure('missing-project', 'There is no such project any more.');
  const kept = migrated(state);
  const base = { stamp: project.stamp, history: checkedHistory(kept.history) };
  const told = recall(id, base);
  const history = { ...(told?.history ?? base.history), gesture: null };
  const all = database.transaction(['photos', 'facts']);
  const read = (/** @type {'photos' | 'facts'} */ table, /** @type {string[]} */ ids) => (
    Promise.all(ids.map((key) => /** @type {any} */ (all.objectStore(table)).get(key))).then((found) => found.filter(Boolean))
  );
  const ids = [...photosOf(history)];
  const fileKeys = kept.videos.map((/** @type {{ fileKey: string }} */ { fileKey }) => fileKey);
  const [records, facts, files] = await Promise.all([read('photos', ids), read('facts', ids), read('photos', fileKeys)]);
  const names = new Map(told?.photos);
  const content = await contentOf(history, { records, facts: facts.map(({ fact }) => fact), videos: kept.videos, files, names });
  return { content, stamp: project.stamp, created: project.created, stored: told ? base.history : undefined };
}

/**
 * Every photo of the history, whatever became of it: what was not decoded, or lost what was known of it, is read again from
 * its file, a frame from its film; where there is neither, an empty frame keeps its place until somebody brings it back.
 * @param {History} history
 * @param {{
 *   records: PhotoRecord[], facts: Fact[], videos: import('./database.js').KeptVideo[], files: PhotoRecord[], names: ReadonlyMap<string, string>,
 * }} found `files` are those of the videos, `names` what the journal tells of photos
 * @returns {Promise<Content>}
 */
async function contentOf(history, { records, facts, videos, files, names }) {
  const films = new Map(files.map((record) => [record.id, record.file]));
  const known = videos.flatMap(({ fileKey, ...video }) => {
    const file = films.get(fileKey);
    return file ? { ...video, file: asFile(file, video.name) } : [];
  });
  const [byId, factOf] = [new Map(records.map((record) => [record.id, record])), new Map(facts.map((fact) => [fact.id, fact]))];
  const filmOf = new Map(known.flatMap(({ key, ids }) => ids.map((id) => [id, key])));
  /** @type {Map<string, Fact>} */
  const album = new Map();
  /** @type {Content['unread']} */
  const unread = [];
  /** @type {Fact[]} */
  const missing = [];
  const unseen = new Set();
  for (const id of photosOf(history)) {
    const record = byId.get(id);
    const { file = null, work = null, small = null } = record ?? {};
    const name = names.get(id) ?? record?.name ?? strings.absentPhoto(missing.length + 1);
    const fact = factOf.get(id) ?? { id, name, meta: null, measures: null };
    album.set(id, fact);
    if (fact.meta && work && small) continue;
    if (file) unread.push({ id, file: asFile(file, fact.name) });
    else if (filmOf.has(id) && !fact.absent) unseen.add(filmOf.get(id));
    else missing.push(fact);
  }
  const empty = await emptyFrames(missing);
  for (const { fact } of empty) album.set(fact.id, fact);
  const inTray = new Set(history.present.tray.map(({ id }) => id));
  return {
    history,
    album,
    videos: new Map(known.map((video) => [video.key, video])),
    records: [...records, ...files],
    unread: [...unread, ...empty.map(({ fact: { id }, file }) => ({ id, file }))],
    films: [...unseen],
    filmless: videos.flatMap(({ fileKey, name }) => (films.get(fileKey) ? [] : name)),
    missing: missing.flatMap(({ id, name }) => (inTray.has(id) ? { id, name } : [])),
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
