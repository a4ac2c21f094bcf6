/** The projects of this browser, and the actions of the project list. */

import { signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { freshId } from '../document/fresh-id.ts';
import { wellFormed } from '../document/limits.ts';
import { drawnId, isProjectId } from './drawn-states.ts';
import { projectLock } from './locks.ts';
import { isGone } from './restoring.ts';
import { withName } from './state-records.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { Database, ProjectRecord } from './database.ts';
import type { Locks } from './locks.ts';
import type { Opening } from './opening.ts';
import type { Saving } from './saving.ts';
import type { Signal } from '@preact/signals';

export type Projects = ReturnType<typeof createProjects>;

/** The greatest that a date can be, in ms. */
const LAST_TIME = 8.64e15;

/** Maximum wait in ms for another tab that still writes the project. */
const PATIENCE = 2_000;

export function createProjects({
  store,
  opening,
  saving,
  locks,
  messages,
  database,
}: {
  store: Store;
  opening: Opening;
  saving: Saving;
  locks: Locks;
  messages: Messages;
  database: () => Promise<Database>;
}) {
  /** All that are not deleted, the last changed first. */
  const list: Signal<readonly ProjectRecord[]> = signal([]);
  const { say, current } = opening;

  return { list, refresh, openCopy, create, duplicate, rename, remove };

  async function create() {
    const done = await opening.create();
    await refresh().catch(() => {});
    return done;
  }

  /** Opens a copy of a project that another tab has. */
  async function openCopy() {
    const other = opening.elsewhere.peek();
    const copy = other && (await duplicate(other.id));
    return copy !== null && opening.open(copy);
  }

  /**
   * Copies a project. An unreadable state is copied unchanged.
   * @returns the id of the copy
   */
  async function duplicate(id: string): Promise<string | null> {
    try {
      if (id === current.peek()) await saving.flush();
      const all = (await database()).transaction(['projects', 'states'], 'readwrite');
      const [projects, states] = [all.objectStore('projects'), all.objectStore('states')];
      const [project, state, drawn] = await Promise.all([projects.get(id), states.get(id), states.get(drawnId(id))]);
      if (!state) return null;
      const [copy, stamp, now] = [freshId(), freshId(), Date.now()];
      const [entry] = entryOf({ ...project, id });
      const name = strings.nameOfCopy(entry.name || strings.untitled);
      await Promise.all([
        projects.put({ ...entry, ...project, id: copy, stamp, name, created: now, changed: now, gone: null }),
        states.put({ ...withName(state, name), id: copy, stamp }),
        ...(drawn ? [states.put({ ...drawn, id: drawnId(copy) })] : []),
        all.done,
      ]);
      await refresh();
      return copy;
    } catch (error) {
      say(error);
      return null;
    }
  }

  /**
   * Renames a project without opening it. An unreadable state retains its name.
   * @returns whether it has it
   */
  async function rename(id: string, wanted: string): Promise<boolean> {
    const name = wanted.trim();
    if (name === '' || name === nameOf(id)) return false;
    if (id === current.peek()) {
      store.change({ type: 'rename', name });
      await saving.flush();
      await refresh().catch(say);
      return true;
    }
    const free = await locks.take(projectLock(id));
    if (!free) {
      messages.alert(strings.openElsewhere({ name: nameOf(id) }));
      return false;
    }
    try {
      await writeName(id, wellFormed(name));
      await refresh();
      return true;
    } catch (error) {
      say(error);
      return false;
    } finally {
      free();
    }
  }

  /**
   * In all of its states: to undo an edit brings no name back that was not undone. The stamp stays, because the journal
   * depends on it.
   */
  async function writeName(id: string, name: string) {
    const all = (await database()).transaction(['projects', 'states'], 'readwrite');
    const [projects, states] = [all.objectStore('projects'), all.objectStore('states')];
    const [project, state, drawn] = await Promise.all([projects.get(id), states.get(id), states.get(drawnId(id))]);
    const named = <T>(states: readonly T[]): T[] => states.map((one) => ({ ...one, name }));
    await Promise.all([
      projects.put({ ...((project ?? entryOf({ id })[0]) as ProjectRecord), name }),
      ...(state ? [states.put(withName(state, name, { all: true }))] : []),
      ...(drawn?.drawn ? [states.put({ ...drawn, drawn: named(drawn.drawn) })] : []),
      all.done,
    ]);
  }

  /** Deletes a project; for a while it can be brought back. */
  async function remove(id: string) {
    try {
      const mine = id === current.peek();
      if (mine && !(await create())) return;
      const free = await locks.take(projectLock(id), mine ? PATIENCE : 0);
      if (!free) {
        messages.alert(strings.openElsewhere({ name: nameOf(id) }));
        return;
      }
      const name = nameOf(id);
      await mark(id, Date.now());
      free();
      messages.offer(strings.projectDeleted({ name }), {
        label: strings.bringBack,
        run: () => void bringBack(id, mine),
      });
    } catch (error) {
      say(error);
    }
  }

  /** @param again whether it was on the page */
  async function bringBack(id: string, again: boolean) {
    await mark(id, null).catch(say);
    if (again && store.tray.peek().length === 0) await opening.open(id);
  }

  async function mark(id: string, gone: number | null) {
    const all = (await database()).transaction('projects', 'readwrite');
    const project = await all.store.get(id);
    await all.store.put({ ...((project ?? entryOf({ id })[0]) as ProjectRecord), gone });
    await all.done;
    await refresh();
  }

  async function refresh() {
    const base = await database();
    const [records, states] = await Promise.all([base.getAll('projects'), base.getAllKeys('states')]);
    const known = new Set(records.map(({ id }) => id));
    // One whose record was lost is there all the same.
    const lost = states.filter((id) => isProjectId(id) && !known.has(id)).map((id) => ({ id }));
    const all = [...records.filter((record) => !isGone(record)), ...lost].flatMap((record) => entryOf(record));
    list.value = all.sort((a, b) => b.changed - a.changed);
  }

  function nameOf(id: string) {
    return list.peek().find((project) => project.id === id)?.name || strings.untitled;
  }
}

/**
 * The list entry of a project, from any record.
 * @returns an empty list for invalid records
 */
function entryOf({
  id,
  name,
  created,
  changed,
  stamp,
  photos,
  picture,
  refs,
}: Partial<ProjectRecord>): ProjectRecord[] {
  if (typeof id !== 'string') return [];
  const time = (value: unknown) => (typeof value === 'number' && Math.abs(value) <= LAST_TIME ? value : 0);
  return [
    {
      id,
      name: typeof name === 'string' ? name : '',
      created: time(created),
      changed: time(changed),
      stamp: String(stamp ?? ''),
      photos: Number.isSafeInteger(photos) ? Number(photos) : 0,
      picture: picture instanceof Blob ? picture : null,
      refs: Array.isArray(refs) ? refs : [],
      gone: null,
    },
  ];
}
