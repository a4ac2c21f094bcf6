/**
 * The last states of a project that were drawn. They are the fallback if a later state cannot be drawn. They are in a
 * separate record, so that damage to one record does not affect the other.
 */

import { ORPHANS } from './orphans.ts';
import type { Project } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Place } from '../document/place.ts';

export type DrawnStates = ReturnType<typeof createDrawnStates>;

/** Number of stored states. */
const MOST = 3;

/**
 * @param id of a project
 * @returns the key of its record among the states, which no project has
 */
export function drawnId(id: string): string {
  return `drawn ${id}`;
}

/**
 * @param key among the states
 * @returns whether it is the key of a project
 */
export function isProjectId(key: unknown): boolean {
  return typeof key === 'string' && key !== ORPHANS && !key.startsWith(drawnId(''));
}

export function createDrawnStates({ store }: { store: Pick<Store, 'project' | 'place' | 'facts'> }) {
  const kept: WeakMap<Place, readonly Project[]> = new WeakMap();
  /** The state that was drawn last, until the next saving. */
  let last: { place: Place; project: Project } | null = null;

  return { note, know, of };

  /**
   * Records that the current page was drawn. Photos that are still being imported may be invalid, so no undo step leads
   * to them.
   */
  function note() {
    const project = store.project.peek();
    if (project.page && store.facts.peek().every(({ meta }) => meta !== null))
      last = { place: store.place.peek(), project };
  }

  /** States that were read with a project. */
  function know(place: Place, states: readonly Project[]) {
    kept.set(place, states);
  }

  /** @returns of its project, the last drawn at the end */
  function of(place: Place): readonly Project[] {
    const before = kept.get(place) ?? [];
    if (last?.place !== place || before.at(-1) === last.project) return before;
    // A state that was restored is another object.
    if (JSON.stringify(before.at(-1)) === JSON.stringify(last.project)) return before;
    const now = [...before, last.project].slice(-MOST);
    kept.set(place, now);
    return now;
  }
}
