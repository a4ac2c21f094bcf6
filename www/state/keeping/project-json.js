// @ts-check
/**
 * `project.json` of a project file: the document, the pages shown, and what is told of each photo and video. The undo
 * stays behind. What a file says the core reads (`readProject`); what the photos say themselves is read from them again.
 */

import { freshId } from '../fresh-id.js';
import { VERSION } from './versions.js';

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
 * @typedef {{ history: KeptHistory, photos: FilePhoto[], videos: FileVideo[], dropped: string[] }} FileProject `dropped`: what was left out, and why
 */

const FORMAT = 'inkpanel';

/**
 * @param {Pick<KeptHistory, 'present' | 'shown'>} history
 * @param {readonly (Fact & { type: string, like?: Likeness })[]} facts with the types of their files
 * @param {readonly Video[]} videos
 * @param {number} [version] of the history, where it is not the newest that there is
 * @returns {{ json: string, paths: Map<string, string> }} `paths`: where in the file each photo is, by its id, and each
 *   video, by `video` and its key
 */
export function projectJson({ present, shown }, facts, videos, version = VERSION) {
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
  return { json: JSON.stringify({ format: FORMAT, version, history, photos, videos: films }, null, 1), paths };
}

/**
 * Reads a project. Its photos get ids that no photo of this browser has: the same file may be opened twice, or be made by hand.
 * @param {string} text
 * @param {Pick<import('../store.js').Planner, 'readProject'>} planner
 * @returns {FileProject} throws `damaged-project` or `newer-project`
 */
export function readProjectJson(text, planner) {
  const { history, photos, videos, dropped } = planner.readProject(text, { prefix: `p${freshId(8)}-` });
  return { history: { ...history, past: [], future: [] }, photos, videos, dropped };
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
