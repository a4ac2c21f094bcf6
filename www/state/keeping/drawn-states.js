// @ts-check
/**
 * The last states of a project that were drawn: ways back when one comes that cannot be. They are written with the
 * project, in a record of their own, so that what spoils the one need not spoil the other.
 */

import { ORPHANS } from './orphans.js';

/** @typedef {import('../place.js').Place} Place */
/** @typedef {import('../project.js').Project} Project */
/** `facts` are the photos that they need. @typedef {{ id: string, version: number, drawn: readonly Project[], facts: string[] }} DrawnRecord */
/** @typedef {ReturnType<typeof createDrawnStates>} DrawnStates */

/** So many are kept. */
const MOST = 3;

/** @param {string} id of a project @returns {string} the key of its record among the states, which no project has */
export function drawnId(id) {
  return `drawn ${id}`;
}

/** @param {unknown} key among the states @returns {boolean} whether it is that of a project */
export function isProjectId(key) {
  return typeof key === 'string' && key !== ORPHANS && !key.startsWith(drawnId(''));
}

/** @param {{ store: Pick<import('../store.js').Store, 'project' | 'place'> }} app */
export function createDrawnStates({ store }) {
  /** @type {WeakMap<Place, readonly Project[]>} */
  const kept = new WeakMap();
  /** The state that was drawn last, until the next saving. @type {{ place: Place, project: Project } | null} */
  let last = null;

  return { note, know, of };

  /** The page is drawn as it is now. */
  function note() {
    const project = store.project.peek();
    if (project.page) last = { place: store.place.peek(), project };
  }

  /** States that were read with a project. @param {Place} place @param {readonly Project[]} states */
  function know(place, states) {
    kept.set(place, states);
  }

  /** @param {Place} place @returns {readonly Project[]} of its project, the last drawn at the end */
  function of(place) {
    const before = kept.get(place) ?? [];
    if (last?.place !== place || before.at(-1) === last.project) return before;
    const now = [...before, last.project].slice(-MOST);
    kept.set(place, now);
    return now;
  }
}
