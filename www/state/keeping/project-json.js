// @ts-check
/**
 * `project.json` of a project file: the document, the pages shown, and what is told of each photo and video. The undo
 * stays behind. What a file says is checked; what the photos say themselves is read from them again.
 */

import { freshId } from '../fresh-id.js';
import { parsedJson } from './bounded-json.js';
import { VERSION, checkedHistory, damaged, migrated } from './versions.js';

/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Video} Video */
/** @typedef {import('./database.js').KeptHistory} KeptHistory */

/** @typedef {import('./identity.js').Likeness} Likeness */

/**
 * `subjects`: what was found in it, null when it was not searched; `measured`: it is compared with other photos; `rank`:
 * its place in time among the photos, null where nobody knows it; `like`: how it is recognised where its file is not
 * here, null where it need not be; `absent`: an empty frame stands for it.
 * @typedef {Pick<Fact, 'id' | 'name' | 'credit' | 'video' | 'time'> & {
 *   path: string, type: string, subjects: any[] | null, measured: boolean, rank: number | null, like: Likeness | null, absent: boolean,
 * }} FilePhoto
 * @typedef {Omit<Video, 'file'> & { path: string, type: string }} FileVideo
 * @typedef {{ history: KeptHistory, photos: FilePhoto[], videos: FileVideo[] }} FileProject
 */

const FORMAT = 'inkpanel';

/** Pixels of a side of a photo, at most. */
const LONGEST_SIDE = 1_000_000;

/**
 * @param {Pick<KeptHistory, 'present' | 'shown'>} history
 * @param {readonly (Fact & { type: string, like?: Likeness })[]} facts with the types of their files
 * @param {readonly Video[]} videos
 * @returns {{ json: string, paths: Map<string, string> }} `paths`: where in the file each photo is, by its id, and each
 *   video, by `video` and its key
 */
export function projectJson({ present, shown }, facts, videos) {
  /** @type {Map<string, string>} */
  const paths = new Map();
  const place = (/** @type {string} */ id, /** @type {string} */ folder, /** @type {string} */ name) => {
    const path = `${folder}/${String(paths.size + 1).padStart(3, '0')}-${name.replaceAll(/[^\p{L}\p{N}._-]+/gu, '-').slice(-60)}`;
    paths.set(id, path);
    return path;
  };
  // When a photo was taken is nobody's business; which came first is enough for their order.
  const times = [...new Set(facts.flatMap(({ meta }) => meta?.taken ?? []))].sort();
  const photos = facts.map(({ id, name, credit, video, time, meta, measures, looked, type, absent, like }) => ({
    id, name, credit, video, time, path: place(id, 'photos', name), type, measured: measures !== null,
    subjects: absent ? absent.subjects : looked && meta ? meta.subjects : null,
    rank: meta?.taken ? times.indexOf(meta.taken) : undefined, like: absent ? likenessOf(absent) : like && likenessOf(like), absent: absent ? true : undefined,
  }));
  const films = videos.map(({ file, ...video }) => ({ ...video, path: place(`video ${video.key}`, 'videos', video.name), type: file.type }));
  const history = { present, shown };
  return { json: JSON.stringify({ format: FORMAT, version: VERSION, history, photos, videos: films }, null, 1), paths };
}

/**
 * @param {string} text
 * @returns {FileProject} throws `damaged-project`, `newer-project` or `too-large-project`
 */
export function parsedProject(text) {
  let value;
  try {
    value = parsedJson(text);
  } catch (error) {
    throw error instanceof SyntaxError ? damaged('project.json: is no JSON') : error;
  }
  if (value?.format !== FORMAT) throw damaged('project.json: is of another program');
  const { history, photos, videos } = migrated(value);
  const list = (/** @type {unknown} */ what, /** @type {string} */ name) => {
    if (!Array.isArray(what)) throw damaged(`${name}: is no list`);
    return what;
  };
  return {
    history: { ...checkedHistory({ present: history?.present, shown: history?.shown }), past: [], future: [] },
    photos: list(photos, 'photos').map(photoOf),
    videos: list(videos ?? [], 'videos').map(videoOf),
  };
}

/** @param {any} photo @param {number} i @returns {FilePhoto} */
function photoOf(photo, i) {
  const { id, name, path, credit, video, time, type, subjects, measured, rank, like, absent } = photo ?? {};
  if (![id, name, path].every((text) => typeof text === 'string' && text !== '')) throw damaged(`photos[${i}]: has no id, name or path`);
  return {
    id, name, path, type: textOr(type, ''), credit: textOr(credit, undefined), video: textOr(video, undefined),
    time: Number.isFinite(time) ? time : undefined, measured: measured !== false,
    subjects: Array.isArray(subjects) && subjects.every(isSubject) ? subjects : null,
    rank: Number.isSafeInteger(rank) && rank >= 0 ? rank : null, like: isLikeness(like) ? likenessOf(like) : null, absent: absent === true,
  };
}

/** @param {any} like */
function isLikeness(like) {
  const { hash, fingerprint, width, height } = like ?? {};
  const sides = [width, height].every((side) => Number.isSafeInteger(side) && side > 0 && side <= LONGEST_SIDE);
  return sides && /^([0-9a-f]{64})?$/.test(hash) && /^[0-9a-f]{16}$/.test(fingerprint);
}

/** @param {Likeness} like @returns {Likeness} nothing else of it */
function likenessOf({ hash, fingerprint, width, height }) {
  return { hash, fingerprint, width, height };
}

/**
 * @param {FilePhoto} photo
 * @param {string | null} taken what its file says, as those of older project files do
 * @returns {string | null} something that sorts as the times do
 */
export function takenBy({ rank }, taken) {
  return rank === null ? taken : String(rank).padStart(9, '0');
}

/** @param {any} video @param {number} i @returns {FileVideo} */
function videoOf(video, i) {
  const { key, name, path, ids, duration, start, end, type } = video ?? {};
  const good = [key, name, path].every((text) => typeof text === 'string') && Array.isArray(ids) && ids.every((id) => typeof id === 'string');
  if (!good) throw damaged(`videos[${i}]: has no key, name, path or frames`);
  const time = (/** @type {unknown} */ value) => (typeof value === 'number' && value >= 0 ? value : null);
  return { key, name, path, ids, type: textOr(type, ''), duration: time(duration), start: time(start) ?? 0, end: time(end) };
}

/** @param {any} subject */
function isSubject(subject) {
  const { label, score, x, y, width, height } = subject ?? {};
  return typeof label === 'string' && [score, x, y, width, height].every((value) => typeof value === 'number' && value >= -1 && value <= 2);
}

/** @template T @param {unknown} value @param {T} other @returns {string | T} */
function textOr(value, other) {
  return typeof value === 'string' ? value : other;
}

/**
 * Gives each photo an id that no photo of this browser has: the same file may be opened twice, or be made by hand.
 * @param {FileProject} project
 * @param {() => string} [fresh]
 * @returns {FileProject}
 */
export function withFreshIds(project, fresh = () => `p${freshId(8)}`) {
  const names = new Map([...project.photos.map(({ id }) => id), ...project.videos.map(({ key }) => key)].map((id) => [id, fresh()]));
  return renamed(project, names);
}

/**
 * @template T
 * @param {T} value
 * @param {ReadonlyMap<string, string>} names
 * @returns {T} the same with other names wherever a text is one of them
 */
export function renamed(value, names) {
  /** @param {unknown} part @returns {unknown} */
  const change = (part) => {
    if (typeof part === 'string') return names.get(part) ?? part;
    if (Array.isArray(part)) return part.map(change);
    if (typeof part !== 'object' || part === null) return part;
    return Object.fromEntries(Object.entries(part).map(([key, item]) => [names.get(key) ?? key, change(item)]));
  };
  return /** @type {T} */ (change(value));
}
