// @ts-check
/**
 * Photos into the database: first the file of each, bare, so that all are safe soon, whether they were decoded or not; then,
 * where there is room, the reduced copies that spare the next visit the decoding.
 *
 * What is written is read back, and `lose` is told what the database turns out to have no more: it is written again from
 * what the page holds. The empty frame of a photo that is absent is drawn anew whenever it is needed, and never written: it
 * must not take the place of a photo that turns up after all.
 */

import { isFull } from './database.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./database.js').PhotoRecord} PhotoRecord */
/** @typedef {import('../album.js').Fact} Fact */
/** @typedef {import('../album.js').Video} Video */
/** What a project refers to. @typedef {{ facts: readonly Fact[], videos: readonly Video[] }} Wanted */
/** What the page holds of a photo or a film: `entry` once it was decoded. @typedef {{ id: string, name: string, file: Blob, entry: ReturnType<ReturnType<typeof import('../../engine/photos.js').createPhotos>['get']> | null }} Held */
/** @typedef {ReturnType<typeof createPhotoRecords>} PhotoRecords */

/** Bytes of each photo that are compared when it is read back. */
const SAMPLE = 64;

/** Files that are written together: many small ones cost little more than one, and none waits long for its turn to be safe. */
const TOGETHER = 40;
const BYTES_TOGETHER = 24 * 2 ** 20;
/** Photos whose copies are written together. */
const COPIES_TOGETHER = 4;
/** So few that wait are written with their copies at once, where they were decoded by now. */
const FEW = 8;

/**
 * @param {{
 *   photos: Pick<ReturnType<typeof import('../../engine/photos.js').createPhotos>, 'has' | 'get'>, originals: ReadonlyMap<string, File>,
 *   room?: () => Promise<number>,
 * }} app `room`: bytes that the browser would still take
 */
export function createPhotoRecords({ photos, originals, room = roomLeft }) {
  /** How much of a photo is kept: its file alone, as it was still being read or there is no room, or all. @type {Map<string, 'file' | 'bare' | 'all'>} */
  const kept = new Map();
  /** Those that could be read no more when they were to be written. @type {Set<string>} */
  const unreadable = new Set();
  /** @type {WeakMap<Blob, string>} */
  const fileKeys = new WeakMap();

  /** Those that the person goes on without. @type {Set<string>} */
  const forgone = new Set();

  /** What was written and is to be read back, when the rest is written, too. @type {PhotoRecord[]} */
  let unproved = [];

  return { keyed, protect, prove, improve, waiting, missing, know, lose, retry, forgo };

  /** Photos that the database is known to have. @param {readonly PhotoRecord[]} records */
  function know(records) {
    for (const { id, file, work } of records) {
      kept.set(id, work ? 'all' : 'file');
      if (file) fileKeys.set(file, id);
    }
  }

  /** @param {readonly string[]} keys that the database has not @returns {number} how many of them it had */
  function lose(keys) {
    return keys.filter((key) => kept.delete(key)).length;
  }

  /** What could not be read may be there again. */
  function retry() {
    unreadable.clear();
  }

  /** @param {readonly string[]} ids that are no longer missed */
  function forgo(ids) {
    for (const id of ids) forgone.add(id);
  }

  /** @param {readonly Video[]} videos @returns {import('./database.js').KeptVideo[]} */
  function keyed(videos) {
    return videos.map(({ file, ...video }) => ({ ...video, fileKey: keyOf(file, video.key) }));
  }

  /** @param {Blob} file @param {string} video */
  function keyOf(file, video) {
    const key = fileKeys.get(file) ?? `file-${video}`;
    fileKeys.set(file, key);
    return key;
  }

  /** @param {Wanted} wanted @returns {number} files that are not in the database, and can be written */
  function waiting(wanted) {
    return unwritten(wanted).length;
  }

  /**
   * What neither the database has nor the page can write. A frame of a film that is still to be taken is not missing: its
   * film is there.
   * @param {Wanted} wanted
   * @returns {Fact[]}
   */
  function missing({ facts, videos }) {
    const gone = facts.filter((fact) => {
      if (kept.has(fact.id) || forgone.has(fact.id) || fact.absent) return false;
      return unreadable.has(fact.id) || (fact.meta !== null && heldOf(fact) === null);
    });
    const films = videos.filter(({ file, key }) => unreadable.has(keyOf(file, key)) && !forgone.has(keyOf(file, key)));
    return [...gone, ...films.map(({ file, key, name }) => ({ id: keyOf(file, key), name, meta: null, measures: null }))];
  }

  /** @param {Fact} fact @returns {Held | null} */
  function heldOf({ id, name, absent }) {
    if (absent) return null;
    const entry = photos.has(id) ? photos.get(id) : null;
    const file = entry?.file ?? originals.get(id);
    return file ? { id, name, file, entry } : null;
  }

  /** @param {Wanted} wanted @returns {Held[]} those that are still being read before those that were: they are the quicker to write */
  function unwritten({ facts, videos }) {
    const open = (/** @type {string} */ id) => !kept.has(id) && !unreadable.has(id);
    const list = facts.flatMap((fact) => (open(fact.id) ? heldOf(fact) ?? [] : []));
    const films = videos.flatMap(({ file, name, key }) => {
      const id = keyOf(file, key);
      return open(id) ? { id, name, file, entry: null } : [];
    });
    return [...list.filter(({ entry }) => entry === null), ...films, ...list.filter(({ entry }) => entry !== null)];
  }

  /**
   * Writes the next files that are not in the database yet.
   * @param {Database} database
   * @param {Wanted} wanted
   * @returns {Promise<number>} how many; none when all are there that can be
   */
  async function protect(database, wanted) {
    const all = unwritten(wanted);
    if (all.length === 0) return 0;
    const alone = all[0].entry !== null && all.length <= FEW;
    const batch = alone ? [all[0]] : batchOf(all);
    const written = alone ? [await tried(database, all[0])] : await putAll(database, batch);
    unproved.push(...written.flatMap((record) => record ?? []));
    return batch.length;
  }

  /**
   * Reads some of the files back that were written.
   * @param {Database} database
   * @returns {Promise<boolean>} whether there were any left
   */
  async function prove(database) {
    const some = unproved.slice(0, TOGETHER);
    unproved = unproved.slice(TOGETHER);
    await verify(database, some);
    return some.length > 0;
  }

  /**
   * Adds their copies to the next photos that have been decoded since their files were written.
   * @param {Database} database
   * @param {Wanted} wanted
   * @returns {Promise<boolean>} whether there were any
   */
  async function improve(database, { facts }) {
    const next = facts.filter(({ id, absent }) => kept.get(id) === 'file' && photos.has(id) && !absent).slice(0, COPIES_TOGETHER);
    await Promise.all(next.map((fact) => addCopies(database, /** @type {Held} */ (heldOf(fact)))));
    return next.length > 0;
  }

  /** @param {Database} database @param {Held} held */
  async function addCopies(database, held) {
    const { id, entry } = held;
    const record = { ...bareOf(held), work: entry?.work ?? null, small: entry?.small ?? null };
    // Its file is safe, whatever becomes of this.
    kept.set(id, 'bare');
    if (!await hasRoom(record)) return;
    try {
      await database.put('photos', record);
    } catch (error) {
      if (isFull(error) || !await allReadable(held)) return;
      throw error;
    }
    kept.set(id, 'all');
    await verify(database, [record]);
  }

  /** @param {Database} database @param {readonly Held[]} batch of files alone @returns {Promise<(PhotoRecord | null)[]>} */
  async function putAll(database, batch) {
    const records = batch.map(bareOf);
    const all = database.transaction('photos', 'readwrite');
    try {
      await Promise.all([...records.map((record) => all.store.put(record)), all.done]);
    } catch (error) {
      all.done.catch(() => {});
      if (isFull(error) && batch.length === 1) throw error;
      // One of them is the reason; the others are none the worse for it.
      const written = [];
      for (const held of batch) written.push(await tried(database, held));
      return written;
    }
    for (const { id } of batch) kept.set(id, 'file');
    return records;
  }

  /**
   * @param {Database} database
   * @param {Held} held
   * @returns {Promise<PhotoRecord | null>} null where it can be read no more
   */
  async function tried(database, held) {
    const { id, entry } = held;
    const bare = bareOf(held);
    try {
      const record = entry ? await put(database, { ...bare, work: entry.work, small: entry.small }) : await putFile(database, bare);
      kept.set(id, record.work ? 'all' : entry ? 'bare' : 'file');
      return record;
    } catch (error) {
      if (isFull(error) || await allReadable(held)) throw error;
      unreadable.add(id);
      return null;
    }
  }

  /** @param {Database} database @param {PhotoRecord} record */
  async function put(database, record) {
    if (await hasRoom(record)) {
      try {
        return await putFile(database, record);
      } catch (error) {
        if (!isFull(error)) throw error;
      }
    }
    return putFile(database, { ...record, work: null, small: null });
  }

  /** The files of all photos are worth more than the copies of some. @param {PhotoRecord} record */
  async function hasRoom({ file, work, small }) {
    return await room() > 4 * ((file?.size ?? 0) + (work?.planes.size ?? 0) + (small?.planes.size ?? 0));
  }

  /** @param {Database} database @param {PhotoRecord} record */
  async function putFile(database, record) {
    try {
      await database.put('photos', record);
      return record;
    } catch (error) {
      if (isFull(error) || record.file === null || record.work === null || await readable(record.file)) throw error;
      // The file was moved or deleted since it was chosen; the copies are all that is left of it.
      const rest = { ...record, file: null };
      await database.put('photos', rest);
      return rest;
    }
  }

  /**
   * Reads photos back that were just written.
   * @param {Database} database
   * @param {readonly PhotoRecord[]} written
   */
  async function verify(database, written) {
    const whole = await Promise.all(written.map(async (record) => {
      const found = await database.get('photos', record.id);
      const parts = [[record.file, found?.file], [record.work?.planes, found?.work?.planes], [record.small?.planes, found?.small?.planes]];
      return (await Promise.all(parts.map(([one, other]) => alike(one, other)))).every(Boolean);
    }));
    const bad = written.filter((_record, i) => !whole[i]);
    for (const { id } of bad) kept.delete(id);
    if (bad.length > 0) throw new Error(`${bad[0].name} could not be read back`);
  }
}

/** @param {Held} held @returns {PhotoRecord} */
function bareOf({ id, name, file }) {
  return { id, name, file, work: null, small: null };
}

/** @param {readonly Held[]} all @returns {Held[]} the first of them, as many as are written together */
function batchOf(all) {
  let bytes = 0;
  const end = all.findIndex(({ file }, i) => {
    bytes += file.size;
    return i > 0 && (i >= TOGETHER || bytes > BYTES_TOGETHER);
  });
  return end < 0 ? [...all] : all.slice(0, end);
}

/** @param {Held} held */
async function allReadable({ file, entry }) {
  const sources = [file, ...(entry ? [entry.work.planes, entry.small.planes] : [])];
  return (await Promise.all(sources.map(readable))).every(Boolean);
}

/** @param {Blob} blob */
async function readable(blob) {
  return blob.slice(0, SAMPLE).arrayBuffer().then(() => true, () => false);
}

/**
 * @param {Blob | null | undefined} one
 * @param {Blob | null | undefined} other
 */
async function alike(one, other) {
  if (!one || !other) return (one ?? null) === (other ?? null);
  if (one.size !== other.size) return false;
  const end = (/** @type {Blob} */ blob) => blob.slice(-SAMPLE).arrayBuffer().then((bytes) => new Uint8Array(bytes).join());
  return await end(one) === await end(other);
}

async function roomLeft() {
  const { quota = Infinity, usage = 0 } = await globalThis.navigator?.storage?.estimate?.() ?? {};
  return quota - usage;
}
