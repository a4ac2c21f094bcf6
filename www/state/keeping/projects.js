// @ts-check
/** The projects of this browser, and what can be done with them in the list. */

import { signal } from '@preact/signals';
import { strings } from '../../strings.js';
import { freshId } from '../fresh-id.js';
import { projectLock } from './locks.js';

/** @typedef {import('./database.js').ProjectRecord} ProjectRecord */
/** @typedef {ReturnType<typeof createProjects>} Projects */

/** The page that is to be deleted may still be writing, so long in ms. */
const PATIENCE = 2_000;

/**
 * @param {{
 *   store: import('../store.js').Store, opening: import('./opening.js').Opening, saving: import('./saving.js').Saving,
 *   locks: import('./locks.js').Locks, messages: import('../messages.js').Messages,
 *   database: () => Promise<import('./database.js').Database>,
 * }} app
 */
export function createProjects({ store, opening, saving, locks, messages, database }) {
  /** All that are not deleted, the last changed first. @type {import('@preact/signals').Signal<readonly ProjectRecord[]>} */
  const list = signal([]);
  const { say, current } = opening;

  return { list, refresh, openCopy, create, duplicate, remove };

  async function create() {
    const done = await opening.create();
    await refresh().catch(() => {});
    return done;
  }

  /** Opens a copy of a project that another tab has. */
  async function openCopy() {
    const other = opening.elsewhere.peek();
    const copy = other && await duplicate(other.id);
    return copy !== null && opening.open(copy);
  }

  /** @param {string} id @returns {Promise<string | null>} the id of the copy */
  async function duplicate(id) {
    try {
      if (id === current.peek()) await saving.flush();
      const all = (await database()).transaction(['projects', 'states'], 'readwrite');
      const [project, state] = await Promise.all([all.objectStore('projects').get(id), all.objectStore('states').get(id)]);
      if (!project || !state) return null;
      const [copy, stamp, now] = [freshId(), freshId(), Date.now()];
      const name = strings.copyOf(project.name || strings.untitled);
      const { present } = state.history;
      await Promise.all([
        all.objectStore('projects').put({ ...project, id: copy, stamp, name, created: now, changed: now, gone: null }),
        all.objectStore('states').put({ ...state, id: copy, stamp, history: { ...state.history, present: { ...present, name } } }),
        all.done,
      ]);
      await refresh();
      return copy;
    } catch (error) {
      say(error);
      return null;
    }
  }

  /** Deletes a project; for a while it can be brought back. @param {string} id */
  async function remove(id) {
    try {
      const mine = id === current.peek();
      if (mine && !await create()) return;
      const free = await locks.take(projectLock(id), mine ? PATIENCE : 0);
      if (!free) {
        messages.alert(strings.openElsewhere(nameOf(id)));
        return;
      }
      const name = nameOf(id);
      await mark(id, Date.now());
      free();
      messages.note(strings.projectDeleted(name), { label: strings.bringBack, run: () => void bringBack(id, mine) });
    } catch (error) {
      say(error);
    }
  }

  /** @param {string} id @param {boolean} again whether it was on the page */
  async function bringBack(id, again) {
    await mark(id, null).catch(say);
    if (again && store.tray.peek().length === 0) await opening.open(id);
  }

  /** @param {string} id @param {number | null} gone */
  async function mark(id, gone) {
    const all = (await database()).transaction('projects', 'readwrite');
    const project = await all.store.get(id);
    if (project) await all.store.put({ ...project, gone });
    await all.done;
    await refresh();
  }

  async function refresh() {
    const all = await (await database()).getAll('projects');
    list.value = all.filter(({ gone }) => gone === null).sort((a, b) => b.changed - a.changed);
  }

  /** @param {string} id */
  function nameOf(id) {
    return list.peek().find((project) => project.id === id)?.name || strings.untitled;
  }
}
