// @ts-check
/** Throws away projects that were deleted a day ago, and photos that no project needs. */

import { PHOTOS_LOCK } from './locks.js';

/** How long a deleted project can be brought back, in ms. */
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
    const projects = await all.objectStore('projects').getAll();
    const over = projects.filter(({ gone }) => gone !== null && gone < now - GRACE).map(({ id }) => id);
    const needed = new Set(projects.filter(({ id }) => !over.includes(id)).flatMap(({ refs }) => refs));
    for (const id of over) {
      void all.objectStore('projects').delete(id);
      void all.objectStore('states').delete(id);
    }
    for (const table of /** @type {const} */ (['facts', 'photos'])) {
      for (const key of await all.objectStore(table).getAllKeys()) if (!needed.has(key)) void all.objectStore(table).delete(key);
    }
    await all.done;
  });
}
