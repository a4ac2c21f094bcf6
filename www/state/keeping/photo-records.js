// @ts-check
/**
 * Photos into the database, each once: the file first, and with it, where there is room, the reduced copies that spare
 * the next visit the decoding.
 */

import { isFull } from './database.js';

/** @typedef {import('./database.js').Database} Database */
/** @typedef {import('./database.js').PhotoRecord} PhotoRecord */
/** @typedef {import('../album.js').Video} Video */
/** @typedef {ReturnType<typeof createPhotoRecords>} PhotoRecords */

/** Bytes of each photo that are compared when it is read back. */
const SAMPLE = 64;

/**
 * @param {{
 *   photos: ReturnType<typeof import('../../engine/photos.js').createPhotos>, originals: ReadonlyMap<string, File>,
 *   room?: () => Promise<number>,
 * }} app `room`: bytes that the browser would still take
 */
export function createPhotoRecords({ photos, originals, room = roomLeft }) {
  /** How much of a photo is kept: its file alone, as it was still being read or there is no room, or all. @type {Map<string, 'file' | 'bare' | 'all'>} */
  const kept = new Map();
  /** @type {WeakMap<Blob, string>} */
  const fileKeys = new WeakMap();

  return { write, writeVideos, know, forget, verify };

  /** Photos that the database is known to have. @param {readonly PhotoRecord[]} records */
  function know(records) {
    for (const { id, file, work } of records) {
      kept.set(id, work ? 'all' : 'file');
      if (file) fileKeys.set(file, id);
    }
  }

  /** The database may have lost them. */
  function forget() {
    kept.clear();
  }

  /**
   * @param {Database} database
   * @param {readonly { id: string, name: string }[]} facts
   * @returns {Promise<PhotoRecord[]>} what was written
   */
  async function write(database, facts) {
    const written = [];
    for (const { id, name } of facts) {
      const state = kept.get(id);
      if (state === 'all' || state === 'bare') continue;
      const entry = photos.has(id) ? photos.get(id) : null;
      const file = entry?.file ?? originals.get(id);
      if (!file || (!entry && state === 'file')) continue;
      const bare = { id, name, file, work: null, small: null };
      const record = entry ? await put(database, { ...bare, work: entry.work, small: entry.small }) : await putFile(database, bare);
      kept.set(id, record.work ? 'all' : entry ? 'bare' : 'file');
      written.push(record);
    }
    return written;
  }

  /**
   * @param {Database} database
   * @param {readonly Video[]} videos
   * @returns {Promise<{ videos: import('./database.js').KeptVideo[], written: PhotoRecord[] }>}
   */
  async function writeVideos(database, videos) {
    const written = [];
    const list = [];
    for (const { file, ...video } of videos) {
      const fileKey = fileKeys.get(file) ?? `file-${video.key}`;
      fileKeys.set(file, fileKey);
      list.push({ ...video, fileKey });
      if (kept.has(fileKey)) continue;
      written.push(await putFile(database, { id: fileKey, name: video.name, file, work: null, small: null }));
      kept.set(fileKey, 'all');
    }
    return { videos: list, written };
  }

  /** @param {Database} database @param {PhotoRecord} record */
  async function put(database, record) {
    const copies = (record.work?.planes.size ?? 0) + (record.small?.planes.size ?? 0);
    const file = record.file?.size ?? 0;
    // The files of all photos are worth more than the copies of some.
    if (await room() > 4 * (copies + file)) {
      try {
        return await putFile(database, record);
      } catch (error) {
        if (!isFull(error)) throw error;
      }
    }
    return putFile(database, { ...record, work: null, small: null });
  }

  /** @param {Database} database @param {PhotoRecord} record */
  async function putFile(database, record) {
    try {
      await database.put('photos', record);
      return record;
    } catch (error) {
      if (isFull(error) || record.file === null || await readable(record.file)) throw error;
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
    for (const record of written) {
      const found = await database.get('photos', record.id);
      const whole = await alike(record.file, found?.file) && await alike(record.work?.planes, found?.work?.planes) &&
        await alike(record.small?.planes, found?.small?.planes);
      if (whole) continue;
      kept.delete(record.id);
      throw new Error(`${record.name} could not be read back`);
    }
  }
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
