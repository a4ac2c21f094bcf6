/**
 * Since when photos are needed by nobody. It is kept among the states, under an id that no project has: a table of its
 * own would need a newer database, which a page of before could no longer open.
 */

import type { Schema } from './database.ts';
import type { IDBPObjectStore } from 'idb';

export type States = Pick<IDBPObjectStore<Schema, ['states'], 'states', 'readwrite'>, 'get' | 'getAllKeys' | 'put'>;

export const ORPHANS = 'orphans';

/** @returns times in ms, by the keys of photos */
export async function orphansIn(states: States): Promise<Map<string, number>> {
  const kept = (await states.get(ORPHANS))?.since;
  return kept instanceof Map ? kept : new Map();
}

export async function putOrphans(states: States, since: Map<string, number>) {
  await states.put({ id: ORPHANS, since });
}

/** Photos that are needed again. */
export async function adopt(states: States, keys: readonly string[]) {
  const since = await orphansIn(states);
  const found = keys.filter((key) => since.delete(key));
  if (found.length > 0) await putOrphans(states, since);
}
