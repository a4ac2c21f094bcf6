// @ts-check
/**
 * Since when photos are needed by nobody. It is kept among the states, under an id that no project has: a table of its
 * own would need a newer database, which a page of before could no longer open.
 */

/** @typedef {import('idb').IDBPObjectStore<import('./database.js').Schema, any, 'states', 'readwrite'>} States */

export const ORPHANS = 'orphans';

/** @param {States} states @returns {Promise<Map<string, number>>} times in ms, by the keys of photos */
export async function orphansIn(states) {
  const kept = /** @type {any} */ (await states.get(ORPHANS))?.since;
  return kept instanceof Map ? kept : new Map();
}

/** @param {States} states @param {Map<string, number>} since */
export async function putOrphans(states, since) {
  await states.put(/** @type {any} */ ({ id: ORPHANS, since }));
}

/** Photos that are needed again. @param {States} states @param {readonly string[]} keys */
export async function adopt(states, keys) {
  const since = await orphansIn(states);
  const found = keys.filter((key) => since.delete(key));
  if (found.length > 0) await putOrphans(states, since);
}
