// @ts-check
/**
 * The tables of the browser's database.
 *
 * - `projects`: what the list of projects shows, one small record each
 * - `states`: the document of a project with its history; under ids that no project has the states of it that were drawn
 *   (`drawn-states.js`), and since when photos are needed by nobody (`orphans.js`)
 * - `facts`: what is known of a photo
 * - `photos`: the file of a photo and, once it was decoded and where there is room, its two reduced copies; or the file of a video
 *
 * Photos have ids that no other photo has in any project, so a copy of a project costs no second copy of them.
 */

import { deleteDB, openDB } from 'idb';

/** @typedef {import('../../engine/protocol.js').PhotoHandle} PhotoHandle */

/**
 * `stamp` changes with each writing; `refs` are the keys in `photos` that the project needs; `held` those of a state of it
 * that could not be opened; `gone`: when it was deleted, in ms.
 * @typedef {{
 *   id: string, name: string, created: number, changed: number, stamp: string, photos: number, picture: Blob | null,
 *   refs: string[], gone: number | null, held?: string[],
 * }} ProjectRecord
 */

/** @typedef {Omit<import('../album.js').Video, 'file'> & { fileKey: string }} KeptVideo */
/** @typedef {Omit<import('../history.js').History, 'gesture'>} KeptHistory */
/** @typedef {{ id: string, version: number, stamp: string, history: KeptHistory, facts: string[], videos: KeptVideo[] }} StateRecord */
/** @typedef {{ id: string, fact: import('../album.js').Fact }} FactRecord */

/**
 * Without `work` the photo must be decoded again; without `file` it could not be read when it was written.
 * @typedef {{ id: string, name: string, file: Blob | null, work: PhotoHandle | null, small: PhotoHandle | null }} PhotoRecord
 */

/**
 * @typedef {import('idb').DBSchema & {
 *   projects: { key: string, value: ProjectRecord },
 *   states: { key: string, value: StateRecord },
 *   facts: { key: string, value: FactRecord },
 *   photos: { key: string, value: PhotoRecord },
 * }} Schema
 */

/** @typedef {import('idb').IDBPDatabase<Schema>} Database */

const TABLES = /** @type {const} */ (['projects', 'states', 'facts', 'photos']);
const NAME = 'inkpanel';
/** Of the tables; what is in them has a version of its own (`versions.js`). */
const VERSION = 1;

/**
 * @param {{ name?: string, onClosed?: () => void }} [options] `onClosed`: it can no longer be used
 * @returns {Promise<Database>} rejects where the browser refuses storage
 */
export async function openDatabase({ name = NAME, onClosed = () => {} } = {}) {
  const database = await open(name, onClosed);
  if (database.objectStoreNames.length > 0) return database;
  // Somebody opened one that was not there, and so made it, without any table.
  database.close();
  await deleteDB(name);
  return open(name, onClosed);
}

/** @param {string} name @param {() => void} onClosed */
async function open(name, onClosed) {
  /** @type {Database} */
  const database = await openDB(name, VERSION, {
    upgrade(made) {
      for (const table of TABLES) {
        if (!made.objectStoreNames.contains(table)) made.createObjectStore(table, { keyPath: 'id' });
      }
    },
    // A newer page in another tab wants other tables, or the database is deleted: neither shall wait for this page.
    blocking: () => {
      database?.close();
      onClosed();
    },
    terminated: onClosed,
  });
  return database;
}

/**
 * @param {unknown} error
 * @returns {boolean} whether the storage took no more
 */
export function isFull(error) {
  return /** @type {{ name?: string }} */ (error)?.name === 'QuotaExceededError';
}
