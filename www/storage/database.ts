/**
 * The tables of the browser's database.
 *
 * - `projects`: entries of the project list, one small record each
 * - `states`: the document of each project with its history. Records under other ids hold the last drawn states
 *   (`drawn-states.ts`) and the dates of unused photos (`orphans.ts`).
 * - `facts`: the measurements of each photo
 * - `photos`: the file of a photo and, after decoding and if space allows, its two reduced copies; or the file of a
 *   video
 *
 * Photos have ids that no other photo has in any project, so a copy of a project costs no second copy of them.
 */

import { deleteDB, openDB } from 'idb';
import type { Fact, Video } from '../document/album.ts';
import type { History } from '../engine/types.ts';
import type { Project } from '../document/project.ts';
import type { PhotoHandle } from '../engine/protocol.ts';
import type { DBSchema, IDBPDatabase } from 'idb';

/**
 * `stamp` changes with each write. `refs` are the keys in `photos` that the project needs. `held` are keys for a state
 * that could not be opened. `gone`: time of deletion, in ms.
 */
export type ProjectRecord = {
  id: string;
  name: string;
  created: number;
  changed: number;
  stamp: string;
  photos: number;
  picture: Blob | null;
  refs: string[];
  gone: number | null;
  held?: string[];
};

export type KeptVideo = Omit<Video, 'file'> & { fileKey: string };
/** `bytes`: the history, as an editor wrote it */
export type StateRecord = {
  id: string;
  version: number;
  stamp: string;
  bytes: Uint8Array<ArrayBuffer>;
  facts: string[];
  videos: KeptVideo[];
};
/** The document of a record that an earlier version wrote (`state-records.ts`). */
type EarlierRecord = { history: History };
/** The states of a project that were drawn (`drawn-states.ts`). */
type DrawnRecord = { id: string; version: number; drawn: readonly Project[]; facts: string[] };
/** Dates since when photos are unused (`orphans.ts`), in ms by key. */
type OrphansRecord = { id: string; since: Map<string, number> };
/** A record in `states`, not validated. */
export type AnyState = { id: string } & Partial<StateRecord & EarlierRecord & DrawnRecord & OrphansRecord>;
type FactRecord = { id: string; fact: Fact };

/** Photo bytes in a database that does not accept Blobs: WebKit in a private window. */
type Bytes = { bytes: ArrayBuffer; name: string | null; type: string };

/** Without `work` the photo must be decoded again; without `file` it could not be read when it was written. */
export type PhotoRecord = {
  id: string;
  name: string;
  file: Blob | null;
  work: PhotoHandle | null;
  small: PhotoHandle | null;
};

export type Schema = DBSchema & {
  projects: { key: string; value: ProjectRecord };
  states: { key: string; value: AnyState };
  facts: { key: string; value: FactRecord };
  photos: { key: string; value: PhotoRecord };
};

export type Database = IDBPDatabase<Schema>;

const TABLES = ['projects', 'states', 'facts', 'photos'] as const;
const NAME = 'inkpanel';
/** Version of the tables; their content has a separate version (`versions.ts`). */
const VERSION = 1;

/**
 * @param options `onClosed`: it can no longer be used
 * @returns rejects if the browser blocks storage
 */
export async function openDatabase({
  name = NAME,
  onClosed = () => {},
}: {
  name?: string;
  onClosed?: () => void;
} = {}): Promise<Database> {
  const database = await open(name, onClosed);
  if (database.objectStoreNames.length > 0) return database;
  // Another page opened a missing database, which created it without tables.
  database.close();
  await deleteDB(name);
  return open(name, onClosed);
}

async function open(name: string, onClosed: () => void) {
  const database: Database = await openDB(name, VERSION, {
    upgrade(made) {
      for (const table of TABLES) {
        if (!made.objectStoreNames.contains(table)) made.createObjectStore(table, { keyPath: 'id' });
      }
    },
    // A newer version in another tab needs other tables, or the database is deleted. Neither must wait for this page.
    blocking: () => {
      database?.close();
      onClosed();
    },
    terminated: onClosed,
  });
  return database;
}

/** Converts a photo record for databases that cannot store blobs. */
export async function inBytes(record: PhotoRecord): Promise<PhotoRecord> {
  const bytesOf = async (blob: Blob) =>
    // Readers call `inBlobs` first.
    ({
      bytes: await blob.arrayBuffer(),
      name: blob instanceof File ? blob.name : null,
      type: blob.type,
    }) satisfies Bytes as unknown as Blob;
  const handle = async (held: PhotoHandle | null) => held && { ...held, planes: await bytesOf(held.planes) };
  const [file, work, small] = await Promise.all([
    record.file && bytesOf(record.file),
    handle(record.work),
    handle(record.small),
  ]);
  return { ...record, file, work, small };
}

/** Converts a photo record of any stored form to blobs. Copies of a draft are left out, so that the photo is decoded again. */
export function inBlobs<Kept extends { file?: unknown; work?: unknown; small?: unknown }>(record: Kept): Kept {
  const handle = (held: unknown) => {
    if (typeof held !== 'object' || held === null || !('planes' in held)) return held;
    return 'draft' in held ? null : { ...held, planes: blobOf(held.planes) };
  };
  return { ...record, file: blobOf(record.file), work: handle(record.work), small: handle(record.small) };
}

function blobOf(kept: unknown): unknown {
  const { bytes, name, type } = (kept ?? {}) as Partial<Bytes>;
  if (!(bytes instanceof ArrayBuffer)) return kept;
  return typeof name === 'string' ? new File([bytes], name, { type }) : new Blob([bytes], { type });
}

/** @returns whether the storage is full */
export function isFull(error: unknown): boolean {
  return (error as { name?: string })?.name === 'QuotaExceededError';
}
