/**
 * Writes photos to the database: first all files, so that they are safe soon, decoded or not. Then, if space allows,
 * the reduced copies, which make the next visit faster.
 *
 * Written data is read back. `lose` receives records that the database lost, and they are written again from memory.
 * The empty frame of a missing photo is drawn on demand and never written, because it must not replace a photo that is
 * found later.
 */

import { inBlobs, inBytes, isFull } from './database.ts';
import type { Fact, Video } from '../document/album.ts';
import type { createPhotos } from '../engine/photos.ts';
import type { Database, KeptVideo, PhotoRecord } from './database.ts';

/** References of a project. */
type Wanted = { facts: readonly Fact[]; videos: readonly Video[] };
/** A photo or video in memory: `entry` after decoding. A draft counts as not decoded. */
type Held = { id: string; name: string; file: Blob; entry: ReturnType<ReturnType<typeof createPhotos>['get']> | null };
export type PhotoRecords = ReturnType<typeof createPhotoRecords>;

/** Bytes of each photo that are compared when it is read back. */
const SAMPLE = 64;

/** Number of files that are written together. A group costs little more than one file, and no file waits long. */
const TOGETHER = 40;
const BYTES_TOGETHER = 24 * 2 ** 20;
/** Photos whose copies are written together. */
const COPIES_TOGETHER = 4;
/** Maximum number of waiting records that are written at once with their copies, if these are decoded. */
const FEW = 8;

/** `room`: free storage in bytes */
export function createPhotoRecords({
  photos,
  originals,
  room = roomLeft,
}: {
  photos: Pick<ReturnType<typeof createPhotos>, 'has' | 'get'>;
  originals: ReadonlyMap<string, File>;
  room?: () => Promise<number>;
}) {
  /** Stored parts of each photo: only its file (`file` during import, `bare` without space for more), or all. */
  const kept: Map<string, 'file' | 'bare' | 'all'> = new Map();
  /** Photos whose files could not be read for writing. */
  const unreadable: Set<string> = new Set();
  const fileKeys: WeakMap<Blob, string> = new WeakMap();

  /** Photos that the user agreed to lose. */
  const forgone: Set<string> = new Set();

  /** Whether the database rejects blobs. */
  let plain = false;

  /** Written records that must still be read back. */
  let unproved: PhotoRecord[] = [];

  return { keyed, protect, prove, improve, waiting, missing, know, lose, retry, forgo };

  /** Records photos that are in the database. */
  function know(records: readonly PhotoRecord[]) {
    for (const { id, file, work } of records) {
      kept.set(id, work ? 'all' : 'file');
      if (file) fileKeys.set(file, id);
    }
  }

  /**
   * @param keys that the database has not
   * @returns number of removed entries
   */
  function lose(keys: readonly string[]): number {
    return keys.filter((key) => kept.delete(key)).length;
  }

  /** Retries unreadable photos. */
  function retry() {
    unreadable.clear();
  }

  /** @param ids that are no longer missed */
  function forgo(ids: readonly string[]) {
    for (const id of ids) forgone.add(id);
  }

  function keyed(videos: readonly Video[]): KeptVideo[] {
    return videos.map(({ file, ...video }) => ({ ...video, fileKey: keyOf(file, video.key) }));
  }

  function keyOf(file: Blob, video: string) {
    const key = fileKeys.get(file) ?? `file-${video}`;
    fileKeys.set(file, key);
    return key;
  }

  /** @returns files that are not in the database, and can be written */
  function waiting(wanted: Wanted): number {
    return unwritten(wanted).length;
  }

  /**
   * Photos that are neither in the database nor writable. A video frame that is not extracted yet is not missing,
   * because its video exists.
   */
  function missing({ facts, videos }: Wanted): Fact[] {
    const gone = facts.filter((fact) => {
      if (kept.has(fact.id) || forgone.has(fact.id) || fact.absent) return false;
      return unreadable.has(fact.id) || (fact.meta !== null && heldOf(fact) === null);
    });
    const films = videos.filter(({ file, key }) => unreadable.has(keyOf(file, key)) && !forgone.has(keyOf(file, key)));
    return [
      ...gone,
      ...films.map(({ file, key, name }) => ({ id: keyOf(file, key), name, meta: null, measures: null })),
    ];
  }

  function heldOf({ id, name, absent }: Fact): Held | null {
    if (absent) return null;
    const found = photos.has(id) ? photos.get(id) : null;
    const file = found?.file ?? originals.get(id);
    return file ? { id, name, file, entry: found?.work.draft ? null : found } : null;
  }

  /** @returns photos during import first, because they are faster to write */
  function unwritten({ facts, videos }: Wanted): Held[] {
    const open = (id: string) => !kept.has(id) && !unreadable.has(id);
    const list = facts.flatMap((fact) => (open(fact.id) ? (heldOf(fact) ?? []) : []));
    const films = videos.flatMap(({ file, name, key }) => {
      const id = keyOf(file, key);
      return open(id) ? { id, name, file, entry: null } : [];
    });
    return [...list.filter(({ entry }) => entry === null), ...films, ...list.filter(({ entry }) => entry !== null)];
  }

  /**
   * Writes the next files to the database.
   * @returns number of written files; 0 if nothing is left
   */
  async function protect(database: Database, wanted: Wanted): Promise<number> {
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
   * @returns whether there were any left
   */
  async function prove(database: Database): Promise<boolean> {
    const some = unproved.slice(0, TOGETHER);
    unproved = unproved.slice(TOGETHER);
    await verify(database, some);
    return some.length > 0;
  }

  /**
   * Adds their copies to the next photos that have been decoded since their files were written.
   * @returns whether there were any
   */
  async function improve(database: Database, { facts }: Wanted): Promise<boolean> {
    const open = facts.flatMap((fact) => (kept.get(fact.id) === 'file' ? (heldOf(fact) ?? []) : []));
    const next = open.filter(({ entry }) => entry !== null).slice(0, COPIES_TOGETHER);
    await Promise.all(next.map((held) => addCopies(database, held)));
    return next.length > 0;
  }

  async function addCopies(database: Database, held: Held) {
    const { id, entry } = held;
    const record = { ...bareOf(held), work: entry?.work ?? null, small: entry?.small ?? null };
    // Its file is safe, whatever becomes of this.
    kept.set(id, 'bare');
    if (!(await hasRoom(record))) return;
    try {
      await write(database, record);
    } catch (error) {
      if (isFull(error) || !(await allReadable(held))) return;
      throw error;
    }
    kept.set(id, 'all');
    await verify(database, [record]);
  }

  /** @param batch files without copies */
  async function putAll(database: Database, batch: readonly Held[]): Promise<(PhotoRecord | null)[]> {
    const records = batch.map(bareOf);
    // Unreadable files are identified one by one, as below.
    const written = plain ? await Promise.all(records.map(inBytes)).catch(() => records) : records;
    const all = database.transaction('photos', 'readwrite');
    try {
      await Promise.all([...written.map((record) => all.store.put(record)), all.done]);
    } catch (error) {
      all.done.catch(() => {});
      if (isFull(error) && batch.length === 1) throw error;
      // One of them failed; the others are valid.
      const one = [];
      for (const held of batch) one.push(await tried(database, held));
      return one;
    }
    for (const { id } of batch) kept.set(id, 'file');
    return records;
  }

  /** @returns null if it cannot be read */
  async function tried(database: Database, held: Held): Promise<PhotoRecord | null> {
    const { id, entry } = held;
    const bare = bareOf(held);
    try {
      const record = entry
        ? await put(database, { ...bare, work: entry.work, small: entry.small })
        : await putFile(database, bare);
      kept.set(id, record.work ? 'all' : entry ? 'bare' : 'file');
      return record;
    } catch (error) {
      if (isFull(error) || (await allReadable(held))) throw error;
      unreadable.add(id);
      return null;
    }
  }

  async function put(database: Database, record: PhotoRecord) {
    if (await hasRoom(record)) {
      try {
        return await putFile(database, record);
      } catch (error) {
        if (!isFull(error)) throw error;
      }
    }
    return putFile(database, { ...record, work: null, small: null });
  }

  /** The files of all photos are worth more than the copies of some. */
  async function hasRoom({ file, work, small }: PhotoRecord) {
    return (await room()) > 4 * ((file?.size ?? 0) + (work?.planes.size ?? 0) + (small?.planes.size ?? 0));
  }

  /** Writes a blob without reading it. If the browser rejects blobs, writes its bytes. */
  async function write(database: Database, record: PhotoRecord) {
    if (!plain) {
      try {
        await database.put('photos', record);
        return;
      } catch (error) {
        if (isFull(error)) throw error;
      }
    }
    // Unreadable files fail here as well.
    await database.put('photos', await inBytes(record));
    plain = true;
  }

  async function putFile(database: Database, record: PhotoRecord) {
    try {
      await write(database, record);
      return record;
    } catch (error) {
      if (isFull(error) || record.file === null || record.work === null || (await readable(record.file))) throw error;
      // The file was moved or deleted since it was chosen; the copies are all that is left of it.
      const rest = { ...record, file: null };
      await write(database, rest);
      return rest;
    }
  }

  /** Reads photos back that were just written. */
  async function verify(database: Database, written: readonly PhotoRecord[]) {
    const whole = await Promise.all(
      written.map(async (record) => {
        const kept = await database.get('photos', record.id);
        const found = kept && inBlobs(kept);
        const parts = [
          [record.file, found?.file],
          [record.work?.planes, found?.work?.planes],
          [record.small?.planes, found?.small?.planes],
        ];
        return (await Promise.all(parts.map(([one, other]) => alike(one, other)))).every(Boolean);
      }),
    );
    const bad = written.filter((_record, i) => !whole[i]);
    for (const { id } of bad) kept.delete(id);
    if (bad.length > 0) throw new Error(`${bad[0].name} could not be read back`);
  }
}

function bareOf({ id, name, file }: Held): PhotoRecord {
  return { id, name, file, work: null, small: null };
}

/** @returns the first files, up to the maximum per write */
function batchOf(all: readonly Held[]): Held[] {
  let bytes = 0;
  const end = all.findIndex(({ file }, i) => {
    bytes += file.size;
    return i > 0 && (i >= TOGETHER || bytes > BYTES_TOGETHER);
  });
  return end < 0 ? [...all] : all.slice(0, end);
}

async function allReadable({ file, entry }: Held) {
  const sources = [file, ...(entry ? [entry.work.planes, entry.small.planes] : [])];
  return (await Promise.all(sources.map(readable))).every(Boolean);
}

async function readable(blob: Blob) {
  return blob
    .slice(0, SAMPLE)
    .arrayBuffer()
    .then(
      () => true,
      () => false,
    );
}

async function alike(one: Blob | null | undefined, other: Blob | null | undefined) {
  if (!one || !other) return (one ?? null) === (other ?? null);
  if (one.size !== other.size) return false;
  const end = (blob: Blob) =>
    blob
      .slice(-SAMPLE)
      .arrayBuffer()
      .then((bytes) => new Uint8Array(bytes).join());
  return (await end(one)) === (await end(other));
}

async function roomLeft() {
  const { quota = Infinity, usage = 0 } = (await globalThis.navigator?.storage?.estimate?.()) ?? {};
  return quota - usage;
}
