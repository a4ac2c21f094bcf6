// @ts-check
/**
 * A project out of the database. Nothing that comes out of it is trusted: the core reads the document, and of the records
 * beside it what is no such record counts as missing.
 */

import { failure } from '../../engine/protocol.js';
import { strings } from '../../strings.js';
import { sheetsOf } from '../sheets.js';
import { drawnId } from './drawn-states.js';
import { emptyFrames } from './placeholder.js';
import { photosOf } from './snapshot.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./database.js').PhotoRecord} PhotoRecord */
/** @typedef {import('./database.js').KeptVideo} KeptVideo */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Video} Video */
/** @typedef {import('../history.js').History} History */
/** @typedef {import('../place.js').Place} Place */
/** @typedef {import('../project.js').Project} Project */
/** @typedef {Promise<import('../store.js').Planner>} Ready */

/**
 * A project in parts: `records` are what the database has of its photos, `unread` files that must be decoded again, `films`
 * the keys of videos whose frames must be; `missing` are the photos in the tray for which an empty frame stands, `filmless`
 * the names of videos that left nothing but their frames; `dropped` tells of parts that could not be read.
 * @typedef {{
 *   history: History, album: ReadonlyMap<string, Fact>, videos: ReadonlyMap<string, Video>, records: PhotoRecord[],
 *   unread: { id: string, file: File }[], films?: string[], missing?: { id: string, name: string }[], filmless?: string[],
 *   dropped?: readonly string[],
 * }} Content
 */

/**
 * @param {Database} database
 * @param {string} id
 * @param {Ready} ready
 * @param {import('./journal.js').Journal['recall']} [recall] what the journal tells of edits that are not in the database
 * @returns {Promise<{ place: Place, content: Content, drawn: Project[] }>} rejects with `missing-project`,
 *   `damaged-project` or `newer-project`
 */
export async function readProject(database, id, ready, recall = () => null) {
  const [place, state] = await Promise.all([placeOf(database, id), database.get('states', id)]);
  if (!state) throw failure('missing-project', 'There is no such project any more.');
  const { readHistory } = await ready;
  const { history: stored, dropped } = readHistory(state);
  const told = recall(id, { stamp: place.stamp, history: stored }, readHistory);
  const drawn = await drawnOf(database, id, ready);
  const names = new Map(told?.photos);
  const content = await contentOf(database, { ...(told?.history ?? stored), gesture: null }, { drawn, state, names });
  return { place: told ? { ...place, stored } : place, content: { ...content, dropped }, drawn };
}

/**
 * @param {Database} database
 * @param {string} id
 * @param {Ready} ready
 * @returns {Promise<Project[]>} the states of a project that were drawn and can be read, the last at the end
 */
export async function drawnOf(database, id, ready) {
  const record = /** @type {any} */ (await database.get('states', drawnId(id)));
  if (!Array.isArray(record?.drawn)) return [];
  const planner = await ready;
  return record.drawn.flatMap((/** @type {any} */ present) => {
    try {
      return [planner.readHistory({ version: record.version, history: { past: [], present, future: [], shown: [] } }).history.present];
    } catch {
      return [];
    }
  });
}

/**
 * A project in a state that it had.
 * @param {Database} database
 * @param {string} id
 * @param {Project} state
 * @returns {Promise<{ place: Place, content: Content }>}
 */
export async function readState(database, id, state) {
  const [place, kept] = await Promise.all([placeOf(database, id), database.get('states', id)]);
  return { place, content: await contentOf(database, beginningWith(state), { state: kept }) };
}

/** @param {Project} state @returns {History} of this state and nothing before it */
export function beginningWith(state) {
  const shown = sheetsOf(state).map(({ page, pageId, sheet }) => (sheet === 0 ? { id: pageId, page } : { id: pageId, page, sheet }));
  return { past: [], present: state, future: [], shown, gesture: null };
}

/** @param {Database} database @param {string} id @returns {Promise<boolean>} whether there is such a project, and not deleted */
export async function isThere(database, id) {
  const project = await database.get('projects', id);
  return project ? !isGone(project) : await database.getKey('states', id) !== undefined;
}

/** @param {import('./database.js').ProjectRecord} project */
export function isGone({ gone }) {
  return typeof gone === 'number';
}

/** @param {Database} database @param {string} id @returns {Promise<string>} what the project is called */
export async function nameOf(database, id) {
  return textOr((await database.get('projects', id))?.name, '');
}

/**
 * Keeps the photos of a state that cannot be shown as long as the project is there, whatever state it goes on with.
 * @param {Database} database
 * @param {string} id
 */
export async function holdPhotos(database, id) {
  const all = database.transaction(['projects', 'states'], 'readwrite');
  const [project, state] = await Promise.all([all.objectStore('projects').get(id), all.objectStore('states').get(id)]);
  if (project) {
    const keys = [...textsIn(project.held), ...textsIn(project.refs), ...textsIn(state?.facts), ...videosIn(state).map(({ fileKey }) => fileKey)];
    await all.objectStore('projects').put({ ...project, held: [...new Set(keys)] });
  }
  await all.done;
}

/** @param {Database} database @param {string} id @returns {Promise<Place>} */
async function placeOf(database, id) {
  const project = await database.get('projects', id);
  return { id, stamp: textOr(project?.stamp, ''), created: Number.isFinite(project?.created) ? Number(project?.created) : Date.now() };
}

/**
 * Every photo of the history, whatever became of it: what was not decoded, or lost what was known of it, is read again from
 * its file, a frame from its film; where there is neither, an empty frame keeps its place until somebody brings it back.
 * @param {Database} database
 * @param {History} history
 * @param {{
 *   drawn?: readonly Project[], state: import('./database.js').StateRecord | undefined, names?: ReadonlyMap<string, string>,
 * }} about `drawn`: states whose photos are needed, too; `state` as it is kept; `names` what the journal tells of photos
 * @returns {Promise<Content>}
 */
async function contentOf(database, history, { drawn = [], state, names = new Map() }) {
  const ids = [...photosOf({ ...history, past: [...history.past, ...drawn] })];
  const kept = videosIn(state);
  const all = database.transaction(['photos', 'facts']);
  const read = (/** @type {'photos' | 'facts'} */ table, /** @type {string[]} */ keys) => (
    Promise.all(keys.map((key) => /** @type {any} */ (all.objectStore(table)).get(key))).then((found) => found.filter(Boolean))
  );
  const [found, told, films] = await Promise.all([read('photos', ids), read('facts', ids), read('photos', kept.map(({ fileKey }) => fileKey))]);
  const [records, files] = [found.map(asRecord), films.map(asRecord)];
  const facts = told.flatMap(({ id, fact }) => (isFact(fact, id) ? [fact] : []));
  const filmOf = new Map(files.map((record) => [record.id, record.file]));
  const videos = kept.flatMap(({ fileKey, ...video }) => {
    const file = filmOf.get(fileKey);
    return file ? [{ ...video, file: asFile(file, video.name) }] : [];
  });
  const { album, unread, frames, missing } = photosFrom(ids, { records, facts, videos, names });
  const empty = await emptyFrames(missing);
  for (const { fact } of empty) album.set(fact.id, fact);
  const inTray = new Set(history.present.tray.map(({ id }) => id));
  return {
    history,
    album,
    videos: new Map(videos.map((video) => [video.key, video])),
    records: [...records, ...files],
    unread: [...unread, ...empty.map(({ fact: { id }, file }) => ({ id, file }))],
    films: frames,
    filmless: kept.flatMap(({ fileKey, name }) => (filmOf.get(fileKey) ? [] : name)),
    missing: missing.flatMap(({ id, name }) => (inTray.has(id) ? { id, name } : [])),
  };
}

/**
 * @param {readonly string[]} ids
 * @param {{ records: readonly PhotoRecord[], facts: readonly Fact[], videos: readonly Video[], names: ReadonlyMap<string, string> }} found
 */
function photosFrom(ids, { records, facts, videos, names }) {
  const [byId, factOf] = [new Map(records.map((record) => [record.id, record])), new Map(facts.map((fact) => [fact.id, fact]))];
  const filmOf = new Map(videos.flatMap((video) => video.ids.map((id) => [id, video.key])));
  /** @type {Map<string, Fact>} */
  const album = new Map();
  /** @type {Content['unread']} */
  const unread = [];
  /** @type {Fact[]} */
  const missing = [];
  /** @type {Set<string>} */
  const frames = new Set();
  for (const id of ids) {
    const record = byId.get(id);
    const { file = null, work = null, small = null } = record ?? {};
    const name = names.get(id) ?? record?.name ?? strings.absentPhoto(missing.length + 1);
    const fact = factOf.get(id) ?? { id, name, meta: null, measures: null };
    album.set(id, fact);
    const film = filmOf.get(id);
    if (fact.meta && work && small) continue;
    if (file) unread.push({ id, file: asFile(file, fact.name) });
    else if (film !== undefined && !fact.absent) frames.add(film);
    else missing.push(fact);
  }
  return { album, unread, frames: [...frames], missing };
}

/** @param {any} record out of the database @returns {PhotoRecord} */
function asRecord({ id, name, file, work, small }) {
  return { id, name: textOr(name, 'photo'), file: file instanceof Blob ? file : null, work: isHandle(work) ? work : null, small: isHandle(small) ? small : null };
}

/** @param {any} handle */
function isHandle(handle) {
  return typeof handle?.key === 'string' && isSide(handle.width) && isSide(handle.height) && handle.planes instanceof Blob;
}

/** @param {any} fact @param {string} id */
function isFact(fact, id) {
  if (fact?.id !== id || typeof fact.name !== 'string') return false;
  const { meta, measures } = fact;
  if (meta === null) return true;
  return meta?.id === id && isSide(meta.width) && isSide(meta.height) && /^[0-9a-f]{16}$/.test(meta.fingerprint) && Number.isFinite(meta.sharpness) &&
    (meta.taken === null || typeof meta.taken === 'string') && typeof meta.energy?.values === 'string' && Array.isArray(meta.subjects) &&
    (measures === null || typeof measures === 'object');
}

/** @param {unknown} side */
function isSide(side) {
  return Number.isSafeInteger(side) && Number(side) > 0;
}

/** @param {any} state @returns {KeptVideo[]} */
function videosIn(state) {
  const list = Array.isArray(state?.videos) ? state.videos : [];
  return list.filter((/** @type {any} */ video) => (
    [video?.key, video?.name, video?.fileKey].every((text) => typeof text === 'string') && Array.isArray(video.ids) &&
    [video.duration ?? 0, video.start, video.end ?? 0].every(Number.isFinite)
  ));
}

/** @param {unknown} list @returns {string[]} */
function textsIn(list) {
  return Array.isArray(list) ? list.filter((text) => typeof text === 'string') : [];
}

/** @param {unknown} text @param {string} other */
function textOr(text, other) {
  return typeof text === 'string' ? text : other;
}

/** @param {Blob} blob @param {string} name */
function asFile(blob, name) {
  return blob instanceof File ? blob : new File([blob], name, { type: blob.type });
}
