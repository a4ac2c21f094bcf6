// @ts-check
/**
 * Throws away projects that were deleted a day ago, and photos that no project has needed for a day. Where a project
 * cannot be read, what it needs is not known either: then all photos stay.
 */

import { drawnId, isProjectId } from './drawn-states.js';
import { PHOTOS_LOCK } from './locks.js';
import { orphansIn, putOrphans } from './orphans.js';

/** @typedef {import('./database.js').ProjectRecord} ProjectRecord */

/** How long a deleted project can be brought back, and how long a photo is kept that nobody needs, in ms. */
const GRACE = 24 * 3600 * 1000;

/**
 * @param {import('./database.js').Database} database
 * @param {Pick<import('./locks.js').Locks, 'during'>} locks
 * @param {number} [now]
 */
export async function sweep(database, locks, now = Date.now()) {
  // While another tab writes photos, none is swept: those of a project that is not written yet look unneeded.
  await locks.during(PHOTOS_LOCK, { mode: 'exclusive', ifAvailable: true }, async () => {
    const all = database.transaction(['projects', 'states', 'facts', 'photos'], 'readwrite');
    const [projects, states] = [all.objectStore('projects'), all.objectStore('states')];
    const records = await projects.getAll();
    const over = records.filter(({ gone }) => typeof gone === 'number' && gone < now - GRACE);
    for (const { id } of over) {
      void projects.delete(id);
      void states.delete(id);
      void states.delete(drawnId(id));
    }
    const needed = await neededBy(records.filter((record) => !over.includes(record)), states);
    if (needed) {
      const before = await orphansIn(states);
      // Photos of a project that is over were needed by nobody else since it was deleted.
      const released = new Map(over.flatMap(({ refs, gone }) => (Array.isArray(refs) ? refs.map((key) => [key, gone]) : [])));
      const since = /** @type {Map<string, number>} */ (new Map());
      for (const table of /** @type {const} */ (['facts', 'photos'])) {
        for (const key of await all.objectStore(table).getAllKeys()) {
          if (needed.has(key)) continue;
          const from = Math.min(before.get(key) ?? released.get(key) ?? now, now);
          if (from < now - GRACE) void all.objectStore(table).delete(key);
          else since.set(key, from);
        }
      }
      if (since.size > 0 || before.size > 0) await putOrphans(states, since);
    }
    await all.done;
  });
}

/**
 * @param {readonly ProjectRecord[]} projects
 * @param {import('./orphans.js').States} states
 * @returns {Promise<Set<string> | null>} the photos that somebody needs; null where that is not known
 */
async function neededBy(projects, states) {
  const needed = /** @type {Set<string>} */ (new Set());
  const need = (/** @type {unknown} */ keys) => {
    const readable = Array.isArray(keys) && keys.every((key) => typeof key === 'string');
    if (readable) keys.forEach((key) => needed.add(key));
    return readable;
  };
  const known = new Set(projects.map(({ id }) => String(id)));
  for (const { id, refs, held } of projects) {
    if (held !== undefined && !need(held)) return null;
    if (!need(refs) && !need(await keysOf(id))) return null;
  }
  // A state whose record in the list was lost is the project all the same.
  for (const id of await states.getAllKeys()) {
    if (!isProjectId(id) || known.has(String(id))) continue;
    if (!need(await keysOf(id))) return null;
  }
  return needed;

  /** @param {string} id */
  async function keysOf(id) {
    const state = /** @type {any} */ (await states.get(id));
    return Array.isArray(state?.facts) ? [...state.facts, ...(Array.isArray(state.videos) ? state.videos.map((/** @type {any} */ video) => video?.fileKey) : [])] : null;
  }
}
