/**
 * Dates since when photos are unused. They are stored in `states` under an id of no project. A separate table would
 * need a newer database version, which older app versions cannot open.
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
