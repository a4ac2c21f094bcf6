/**
 * Throws away projects that were deleted a day ago, and photos that no project has needed for a day. If a project
 * cannot be read, its photos are unknown. Then all photos are retained.
 */

import { drawnId, isProjectId } from './drawn-states.ts';
import { PHOTOS_LOCK } from './locks.ts';
import { orphansIn, putOrphans } from './orphans.ts';
import type { Database, ProjectRecord } from './database.ts';
import type { Locks } from './locks.ts';
import type { States } from './orphans.ts';

/** Time in ms until deleted projects and unused photos are removed. */
const GRACE = 24 * 3600 * 1000;

export async function sweep(database: Database, locks: Pick<Locks, 'during'>, now: number = Date.now()) {
  // While another tab writes photos, nothing is deleted, because photos of an unwritten project look unused.
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
    const needed = await neededBy(
      records.filter((record) => !over.includes(record)),
      states,
    );
    if (needed) {
      const before = await orphansIn(states);
      // Photos of a deleted project are unused since its deletion.
      const released = new Map(
        over.flatMap(({ refs, gone }) => (Array.isArray(refs) ? refs.map((key) => [key, gone]) : [])),
      );
      const since = new Map() as Map<string, number>;
      for (const table of ['facts', 'photos'] as const) {
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

/** @returns the photos in use; null if they are unknown */
async function neededBy(projects: readonly ProjectRecord[], states: States): Promise<Set<string> | null> {
  const needed = new Set() as Set<string>;
  const need = (keys: unknown) => {
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

  async function keysOf(id: string) {
    const state = await states.get(id);
    return Array.isArray(state?.facts)
      ? [...state.facts, ...(Array.isArray(state.videos) ? state.videos.map((video) => video?.fileKey) : [])]
      : null;
  }
}
