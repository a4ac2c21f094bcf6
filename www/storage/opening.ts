/**
 * Manages the open project. A project is open in only one tab. Another tab offers a copy, and opens the project when
 * the first tab closes it.
 */

import { computed, effect, signal } from '@preact/signals';
import { failure } from '../engine/protocol.ts';
import { strings } from '../strings/strings.ts';
import { freshPlace } from '../document/place.ts';
import { projectLock } from './locks.ts';
import { drawnOnce, exchanged, rehearsed } from './rehearsing.ts';
import { beginningWith, drawnOf, holdPhotos, isThere, nameOf, readProject, readState } from './restoring.ts';
import { codeOf, detailOf, explain } from '../ui/explain.ts';
import type { Messages } from '../ui/messages.ts';
import type { Project } from '../document/project.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Reading } from '../photos/reading.ts';
import type { Database } from './database.ts';
import type { DrawnStates } from './drawn-states.ts';
import type { Journal } from './journal.ts';
import type { createLastProject } from './last-project.ts';
import type { Locks } from './locks.ts';
import type { PhotoRecords } from './photo-records.ts';
import type { Place } from '../document/place.ts';
import type { Rehearsed } from './rehearsing.ts';
import type { Content } from './restoring.ts';
import type { Saving } from './saving.ts';
import type { Shelves } from './shelves.ts';
import type { Signal } from '@preact/signals';

export type Opening = ReturnType<typeof createOpening>;

/** Time in ms that a reloaded tab waits for its previous self to release the lock. */
const PATIENCE = 2_000;

/**
 * A project that cannot be shown. `why` is a key of the reasons in `strings`, `detail` the position of the error.
 * `back`: whether it has earlier states.
 */
type Broken = { id: string; name: string; why: string; detail: string; back: boolean };
/** `drawn` resolves when the views have drawn the store, and rejects on an error; `retry` draws again. */
export type Views = { drawn: () => Promise<void>; retry: () => void };

/** Reasons that are not the project's. */
const OUTSIDE = new Set(['not-saved', 'missing-project', 'no-storage']);

function isOutside(error: unknown) {
  return OUTSIDE.has((error as { code: string }).code);
}

/**
 * @param app `leave` closes the parts of the previous project. `onMissing`: photos of the opened project are missing.
 *   `onUnwritten`: photos of a project were never written.
 */
export function createOpening({
  store,
  reading,
  engine,
  shelves,
  saving,
  records,
  locks,
  messages,
  database,
  journal,
  last,
  drawnStates,
  leave,
  onMissing,
  onUnwritten,
  views = { retry: () => {}, drawn: async () => {} },
}: {
  store: Store;
  reading: Pick<Reading, 'resume'>;
  engine: Pick<Engine, 'ready' | 'photos' | 'renderPage'>;
  shelves: Pick<Shelves, 'lists'>;
  saving: Saving;
  records: PhotoRecords;
  locks: Locks;
  messages: Pick<Messages, 'alert' | 'note'>;
  database: () => Promise<Database>;
  journal: Pick<Journal, 'recall' | 'names'>;
  last: ReturnType<typeof createLastProject>;
  drawnStates: DrawnStates;
  leave: () => void;
  views?: Views;
  onMissing: (photos: readonly { id: string; name: string }[]) => void;
  onUnwritten: (names: readonly string[]) => void;
}) {
  /** The project that another tab has open. */
  const elsewhere: Signal<{ id: string; name: string; follows: boolean } | null> = signal(null);
  const broken: Signal<Broken | null> = signal(null);
  const first = last.recall();
  /** Whether the project of the last visit is still on its way. */
  const running = signal(first !== null);
  /** Number of projects that are about to replace this one. */
  const turns = signal(0);
  const turning = computed(() => turns.value > 0);
  /** Photos on their way belong to the project that is there. */
  const busy = computed(() => store.reading.value !== null || store.fetching.value);
  let release = () => {};
  let trying = false;
  /** Ends the waiting for a project that another tab has. */
  let waiting = new AbortController();
  /** One after the other. */
  let queue: Promise<unknown> = Promise.resolve();
  /** Settles when the tab's project is open or has failed. */
  let begun: Promise<unknown> = Promise.resolve();
  /** Earlier states of the broken project that were restored without success. */
  const vain: Set<string> = new Set();

  return {
    elsewhere,
    broken,
    running,
    turning,
    busy,
    current: computed(() => store.place.value.id),
    begin,
    /** Resolves when no other project is about to be opened, including the first one. */
    turned: () => begun.then(() => queue).then(() => {}),
    open,
    create,
    enter,
    goOnAsCopy,
    goBack,
    failedToShow,
    say,
  };

  /** Opens the project of this tab, or the last open project. */
  function begin(): Promise<void> {
    const opened = beginNow();
    begun = opened;
    return opened;
  }

  async function beginNow() {
    try {
      release = await lockOf(store.place.peek());
      if (first) await openLast(first);
      else last.opened(store.place.peek().id);
    } catch (error) {
      say(error);
    } finally {
      running.value = false;
    }
  }

  async function openLast({ id, here }: { id: string; here: boolean }) {
    const base = await database();
    if (!(await isThere(base, id))) {
      if (here && !(await base.get('projects', id))) onUnwritten(journal.names(id));
      return last.opened(store.place.peek().id);
    }
    const free = await locks.take(projectLock(id), here ? PATIENCE : 0);
    if (free) return load(id, free);
    last.opened(store.place.peek().id);
    elsewhere.value = { id, name: await nameOf(base, id), follows: true };
    void follow(id);
  }

  /** Opens a project when the other tab closes it, unless another project was started here. */
  async function follow(id: string) {
    const { signal: stop } = waiting;
    const free = await locks.wait(projectLock(id), stop).catch(() => null);
    if (!free) return;
    if (elsewhere.peek()?.id !== id || store.tray.peek().length > 0) free();
    else await load(id, free).catch(say);
  }

  /** @returns whether it is the one on the page now */
  async function open(id: string): Promise<boolean> {
    if (id === store.place.peek().id) return true;
    turns.value += 1;
    return openNow(id).finally(() => {
      turns.value -= 1;
    });
  }

  async function openNow(id: string) {
    const free = await locks.take(projectLock(id));
    if (!free) {
      elsewhere.value = { id, name: await nameOf(await database(), id), follows: false };
      return false;
    }
    try {
      await load(id, free);
      return id === store.place.peek().id;
    } catch (error) {
      say(error);
      return false;
    }
  }

  /**
   * Opens a project. An error is shown, and the current project stays open.
   * @param free releases its lock
   */
  async function load(id: string, free: () => void) {
    const base = await database();
    try {
      const found = await readProject(base, id, engine.ready, journal.recall);
      await arrive(found, free).catch(async (error) => {
        // The edits in the journal may be the reason for the error.
        if (!found.place.behind || isOutside(error)) throw error;
        await arrive(await readProject(base, id, engine.ready), free);
      });
    } catch (error) {
      free();
      if (isOutside(error)) throw error;
      await holdPhotos(base, id).catch(() => {});
      const back = (await drawnOf(base, id, engine.ready).catch(() => [])).length > 0;
      breaks({ id, name: await nameOf(base, id), back }, error);
    }
  }

  async function arrive({ place, content, drawn }: Awaited<ReturnType<typeof readProject>>, free: () => void) {
    await enter(place, content, free);
    drawnStates.know(place, drawn);
    records.know(content.records);
    if (content.missing?.length) onMissing(content.missing);
    if (content.filmless?.length)
      messages.alert(strings.filmsNotHere({ names: strings.someNames(content.filmless), n: content.filmless.length }));
    if (content.dropped?.length) {
      await database()
        .then((base) => holdPhotos(base, place.id))
        .catch(() => {});
      messages.alert(
        strings.partsLeftOut({ name: store.project.peek().name || strings.untitled, n: content.dropped.length }),
      );
    }
    void reading.resume(content.unread, content.films);
  }

  function breaks(project: Pick<Broken, 'id' | 'name' | 'back'>, error: unknown) {
    vain.clear();
    broken.value = { ...project, why: codeOf(error), detail: detailOf(error) };
  }

  /**
   * Replaces the project by an empty one.
   * @returns whether a project was created
   */
  async function create(): Promise<boolean> {
    try {
      await enter(freshPlace(), { album: new Map(), videos: new Map(), records: [], unread: [] });
      return true;
    } catch (error) {
      say(error);
      return false;
    }
  }

  /**
   * Replaces the open project after it was saved and the new project was checked. Rejects with `not-saved` if saving
   * fails. Nothing changes before that. Later errors restore the old project.
   * @param free releases its lock, if it is already held; on an error the caller still holds it
   * @param how `join`: adds its styles and layouts to this browser
   */
  function enter(next: Place, content: Content, free?: () => void, how?: { join?: boolean }): Promise<void> {
    const turn = queue.then(() => enterNow(next, content, free, how));
    queue = turn.catch(() => {});
    return turn;
  }

  async function enterNow(
    next: Parameters<typeof enter>[0],
    content: Parameters<typeof enter>[1],
    free: Parameters<typeof enter>[2],
    { join = false }: Parameters<typeof enter>[3] = {},
  ): ReturnType<typeof enter> {
    const planner = await engine.ready;
    await allRead();
    const lock = free ?? (await lockOf(next));
    turns.value += 1;
    try {
      const whole = rehearsed(content, { planner, shared: shelves.lists(), join });
      // If nothing can be lost, the check does not delay.
      if (store.tray.peek().length > 0) await drawnOnce(whole, engine);
      await saving.flush();
      if (next.id !== store.place.peek().id && !saving.isSafe())
        throw failure('not-saved', 'This project is not saved.');
      await saving.during(() => shown(whole, next));
    } catch (error) {
      if (!free) lock();
      throw error;
    } finally {
      turns.value -= 1;
    }
    arrived(next, lock);
    leave();
  }

  async function shown(content: Rehearsed, next: Place) {
    const turn = exchanged(content, next, { store, photos: engine.photos });
    trying = true;
    try {
      views.retry();
      await views.drawn();
      turn.settle();
    } catch (error) {
      turn.takeBack();
      views.retry();
      throw error;
    } finally {
      trying = false;
    }
  }

  /** Continues the open project as a copy. The original stays unchanged. */
  async function goOnAsCopy() {
    const next = freshPlace();
    const lock = await lockOf(next);
    const [album, videos] = [store.album.peek(), store.videos.peek()];
    store.load({ editing: store.editing(), album, videos, place: next });
    arrived(next, lock);
  }

  /** Handles an error of the views while drawing the project. */
  function failedToShow(error: unknown) {
    // The caller that tries this state reverts it.
    if (trying) return;
    const place = store.place.peek();
    breaks({ id: place.id, name: store.project.peek().name, back: drawnStates.of(place).length > 0 }, error);
  }

  /**
   * Opens the last state of the broken project that was drawn and can be again.
   * @returns whether one is on the page now
   */
  async function goBack(): Promise<boolean> {
    const project = broken.peek();
    if (!project) return false;
    const here = project.id === store.place.peek().id;
    try {
      const free = here ? release : await locks.take(projectLock(project.id), PATIENCE);
      if (!free) {
        elsewhere.value = { id: project.id, name: project.name, follows: false };
        return false;
      }
      const done = await (here ? goBackHere(free) : goBackTo(project.id, free));
      if (done) messages.note(strings.wentBack({ name: project.name || strings.untitled }));
      else broken.value = { ...project, back: false };
      if (!done && !here) free();
      return done;
    } catch (error) {
      say(error);
      return false;
    }
  }

  async function goBackHere(free: () => void) {
    const place = store.place.peek();
    const [album, videos] = [store.album.peek(), store.videos.peek()];
    return tried(drawnStates.of(place), async (state) => {
      await enter(place, { history: beginningWith(state), album, videos, records: [], unread: [] }, free);
    });
  }

  async function goBackTo(id: string, free: () => void) {
    const base = await database();
    const states = await drawnOf(base, id, engine.ready);
    return tried(states, async (state) => {
      await arrive({ ...(await readState(base, id, state)), drawn: [...states] }, free);
    });
  }

  /** @param states the last drawn at the end */
  async function tried(states: readonly Project[], attempt: (state: Project) => Promise<void>) {
    for (const state of states.toReversed()) {
      const essence = JSON.stringify(state);
      if (vain.has(essence)) continue;
      vain.add(essence);
      try {
        await attempt(state);
        return true;
      } catch (error) {
        if (isOutside(error)) throw error;
      }
    }
    return false;
  }

  /** Photos on their way arrive first. */
  function allRead(): Promise<void> {
    return new Promise((resolve) => {
      const stop = effect(() => {
        if (!busy.value)
          queueMicrotask(() => {
            stop();
            resolve();
          });
      });
    });
  }

  async function lockOf({ id }: Place) {
    return (await locks.take(projectLock(id))) ?? (() => {});
  }

  function arrived(place: Place, lock: () => void) {
    if (release !== lock) release();
    release = lock;
    waiting.abort();
    waiting = new AbortController();
    elsewhere.value = null;
    broken.value = null;
    last.opened(place.id);
  }

  function say(error: unknown) {
    messages.alert(strings.projectNotOpened({ why: explain(error, { reasons: strings.projectReasons }) }));
  }
}
