/**
 * Automatic saving. The state is written first: the document, the measurements and the list of its photos. This happens
 * a moment after a change, after at most a second of changes, and immediately after photos were added. Their files
 * follow and are counted. The status becomes `saved` only after the state was read back and all its references were
 * found in the database. Missing records are written again from memory. A failed save is retried automatically, except
 * for lack of space. Each step waits until the page is drawn, copies of photos also until the user rests, so that a page
 * appears without delay.
 *
 * Each snapshot is written to its own place, and the save status belongs to that place. So a project never overwrites
 * another one.
 */

import { effect, signal, untracked } from '@preact/signals';
import { failure } from '../engine/protocol.ts';
import { freshId } from '../document/fresh-id.ts';
import { isFull } from './database.ts';
import { drawnId } from './drawn-states.ts';
import { PHOTOS_LOCK } from './locks.ts';
import { adopt } from './orphans.ts';
import { snapshotOf } from './snapshot.ts';
import { RECORD, hasDocument, isBytes } from './state-records.ts';
import { VERSION } from '../engine/versions.ts';
import { createTimer } from '../engine/scheduler.ts';
import type { Fact } from '../document/album.ts';
import type { Store } from '../document/store.ts';
import type { Editing } from '../document/editing.ts';
import type { Database, KeptVideo } from './database.ts';
import type { DrawnStates } from './drawn-states.ts';
import type { Journal } from './journal.ts';
import type { Locks } from './locks.ts';
import type { PhotoRecords } from './photo-records.ts';
import type { Place } from '../document/place.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Snapshot } from './snapshot.ts';
import type { Signal } from '@preact/signals';

/** `missing`: some photos cannot be read, everything else is saved. */
export type Status = 'empty' | 'saving' | 'saved' | 'missing' | 'full' | 'refused' | 'failed';
/**
 * A state that is in the database, or may be: an editor after a number of changes. Without an editor, no changes lead
 * from there to the present state.
 */
type Base = { stamp: string; editing: Editing | null; at: number };
/** State at one moment: everything, the snapshot, and the number of photos. */
type Moment = { now: unknown[]; shot: Snapshot; known: number };
/**
 * Save state of one project:
 *
 * - `facts`: as written
 * - `clean`: the last state without unsaved changes; `dirty`: there are unsaved changes; `due`: they are to be written
 *   now
 * - `base`: the state in the database; `next`: the state that is being written
 * - `shot`: the last written snapshot, and `bytes` its history; `complete`: all its photos are written; `looked`: they
 *   were checked
 * - `known`: number of photos at that time
 * - `covered`: the journal has all other changes
 * - `inFile`: the state that was saved as a file
 * - `since`: time of the first unsaved change
 */
type Ledger = {
  place: Place;
  facts: Map<string, Fact>;
  clean: unknown[];
  dirty: boolean;
  due: Moment | null;
  base: Base;
  next: Base | null;
  bytes: Uint8Array | null;
  shot: Snapshot | null;
  looked: boolean;
  complete: boolean;
  known: number;
  covered: boolean;
  done: number;
  inFile: unknown;
  since: number;
  status: Status;
};
export type Saving = ReturnType<typeof createSaving>;

/** Milliseconds. */
const QUIET = 250;
const LONGEST = 1000;
/** Pauses before what could not be saved is tried again: the first, each twice the one before, and the longest. */
const PAUSE = 1000;
const LONGEST_PAUSE = 60_000;
/** Number of repairs of lost records before the storage counts as unreliable. */
const MOST_REPAIRS = 3;
/** Maximum wait of a step for the page, in milliseconds. */
const PATIENCE = 2000;

/** @param app `onWritten`: the state is in the database; `onSaved`: its photos are, too */
export function createSaving({
  store,
  records,
  journal,
  locks,
  database,
  drawnStates,
  scheduler,
  onTrouble,
  onWritten = () => {},
  onSaved = () => {},
}: {
  store: Store;
  records: PhotoRecords;
  journal: Journal;
  locks: Locks;
  database: () => Promise<Database>;
  drawnStates: Pick<DrawnStates, 'of'>;
  scheduler: Pick<Scheduler, 'turn'>;
  onTrouble: (status: Status, error: Error) => void;
  onWritten?: (place: Place) => void;
  onSaved?: (place: Place) => void;
}) {
  const status: Signal<Status> = signal('empty');
  /** Progress of writing files; null if idle. */
  const progress: Signal<{ done: number; total: number } | null> = signal(null);
  /** Whether something would be lost if the page closed now. */
  const unsaved = signal(false);
  /** Photos and videos that are neither in the database nor readable. */
  const missing: Signal<readonly Fact[]> = signal([]);
  /** Save states by place, so that a project keeps its state after a temporary exchange. */
  const ledgers: WeakMap<Place, Ledger> = new WeakMap();
  let ledger = ledgerOf(store.place.peek());
  let running: Promise<void> | null = null;
  let attempts = 0;
  /** Pending trial of a project, which may be reverted. */
  let trial: Promise<void> | null = null;
  const timer = createTimer();
  /** Number of running calls of `flush`, and what ends the wait for the page. */
  let flushing = 0;
  let waiting = new AbortController();

  effect(() => {
    const place = store.place.value;
    const now = parts();
    untracked(() => {
      if (place !== ledger.place) turnTo(place);
      touch(now);
    });
  });

  return { status, progress, unsaved, missing, flush, during, check, again, isSafe, filed };

  function parts() {
    return [store.mirror.value, store.album.value, store.videos.value];
  }

  function ledgerOf(place: Place): Ledger {
    const found = ledgers.get(place);
    if (found) return found;
    const kept = place.stamp !== '';
    const now = parts();
    const { behind } = place;
    const fresh: Ledger = {
      place,
      facts: new Map(kept ? store.album.peek() : []),
      // Data from the database is saved, except edits from the journal. New data must still be written.
      clean: kept ? [behind ? null : now[0], ...now.slice(1)] : [],
      dirty: false,
      due: null,
      base: { stamp: place.stamp, editing: behind === 'wholly' ? null : store.editing(), at: 0 },
      next: null,
      bytes: null,
      shot: null,
      looked: false,
      complete: false,
      known: kept ? store.album.peek().size : 0,
      covered: true,
      done: 0,
      inFile: null,
      since: 0,
      status: kept ? 'saved' : 'empty',
    };
    ledgers.set(place, fresh);
    return fresh;
  }

  function turnTo(place: Place) {
    timer.stop();
    ledger.status = status.peek();
    ledger = ledgerOf(place);
    attempts = 0;
    progress.value = null;
    missing.value = [];
    say(ledger.status);
  }

  function say(now: Status) {
    status.value = now;
    weigh();
  }

  /** Checks for unsaved data. Edits in the journal and photos that only need decoding are safe. */
  function weigh() {
    const now = status.peek();
    const loose = () =>
      !ledger.covered || records.waiting({ facts: store.facts.peek(), videos: [...store.videos.peek().values()] }) > 0;
    unsaved.value = now === 'saving' ? loose() : now !== 'saved' && now !== 'empty';
  }

  function touch(now: unknown[]) {
    if (now.every((part, i) => part === ledger.clean[i])) return;
    const { tray, name } = store.project.peek();
    if (ledger.place.stamp === '' && tray.length === 0 && name === '') return;
    if (!ledger.dirty) ledger.since = performance.now();
    ledger.dirty = true;
    if (!trial) tell(ledger);
    say(
      status.peek() === 'saved' || status.peek() === 'empty' || status.peek() === 'missing' ? 'saving' : status.peek(),
    );
    // Photos are not in the journal.
    const quiet = store.album.peek().size > ledger.known && attempts === 0 ? 0 : QUIET;
    timer.start(Math.max(0, Math.min(quiet, ledger.since + LONGEST - performance.now())), save);
  }

  /** Writes unsaved changes to the journal. */
  function tell({ place: { id }, clean, base, next, facts }: Ledger) {
    if (store.mirror.peek() === clean[0]) {
      journal.clear(id);
      ledger.covered = true;
      return;
    }
    const photos = store.facts
      .peek()
      .filter((fact) => !facts.has(fact.id))
      .map((fact) => [fact.id, fact.name] as const);
    const bases = next ? [base, next] : [base];
    // The journal has only the names of photos if the project was never written.
    const told = bases.filter(({ stamp }) => stamp !== '');
    const editing = store.editing();
    const first = Math.min(...told.map(({ at }) => at));
    const changes = told.length > 0 ? editing?.since(first) : [];
    if (!changes || told.some((one) => one.editing !== editing)) {
      journal.clear(id);
      ledger.covered = false;
      return;
    }
    ledger.covered = journal.note(id, {
      bases: bases.map(({ stamp, at }) => ({ stamp, from: stamp === '' ? 0 : at - first })),
      changes,
      photos,
    });
  }

  /** @returns when all that there is now was written, or could not be */
  async function flush(): Promise<void> {
    timer.stop();
    flushing += 1;
    waiting.abort();
    try {
      if (running) {
        if (ledger.dirty) ledger.due = moment();
        await running;
      }
      if (ledger.dirty || !['saved', 'empty', 'missing'].includes(status.peek())) await save();
    } finally {
      flushing -= 1;
    }
  }

  /** Resolves when the page is drawn; for copies of photos, also after a rest. */
  async function rested(of: Ledger) {
    let over = false;
    while (!over && flushing === 0) {
      waiting = new AbortController();
      const { signal } = waiting;
      const turn =
        of.complete && !of.due
          ? scheduler.turn('background', { signal })
          : scheduler.turn('requested', { signal, latest: performance.now() + PATIENCE });
      over = await turn.then(
        () => true,
        () => false,
      );
    }
  }

  /** Checks that saved data still exists, for example after the database was closed, and restores it. */
  async function check(): Promise<void> {
    if (ledger.place.stamp === '') return;
    ledger.shot ??= moment().shot;
    ledger.looked = ledger.complete = false;
    await run();
  }

  /** Retries unreadable photos. */
  function again(): Promise<void> {
    records.retry();
    return save();
  }

  async function save(): Promise<void> {
    timer.stop();
    if (trial) {
      await trial;
      if (!ledger.dirty) return;
    }
    // A changed project need not wait for a rest.
    if (!ledger.due) waiting.abort();
    ledger.due = moment();
    return run();
  }

  /** Suspends saving and the journal while a project is tried. */
  function during<T>(work: () => Promise<T>): Promise<T> {
    let over = () => {};
    trial = new Promise((resolve) => {
      over = resolve;
    });
    return work().finally(() => {
      trial = null;
      if (ledger.dirty) tell(ledger);
      over();
    });
  }

  function moment(): Moment {
    return {
      now: untracked(parts),
      shot: snapshotOf(store, drawnStates.of(store.place.peek())),
      known: store.album.peek().size,
    };
  }

  function run(): Promise<void> {
    running ??= work(ledger).finally(() => {
      running = null;
      // Changes during the end of the last step.
      if (ledger.due) void run();
    });
    return running;
  }

  async function work(of: Ledger) {
    try {
      let repairs = 0;
      // If another project replaced this one, the old one is saved first. Its photos belong to the other project.
      while (of === ledger || of.due) {
        await rested(of);
        const base = await database();
        const step = await locks.during(PHOTOS_LOCK, { mode: 'shared' }, () => stepOf(of, base));
        if (step === 'done') return;
        if (step === 'lost' && (repairs += 1) > MOST_REPAIRS) throw new Error('What was saved could not be read back.');
      }
    } catch (error) {
      failed(of, error as Error);
    }
  }

  /**
   * The most urgent step: the list of photos, their files, the newest state (which the journal covers meanwhile), then
   * the check. Copies of photos have time.
   * @returns `lost`: the database lost data
   */
  async function stepOf(of: Ledger, base: Database): Promise<'on' | 'lost' | 'done'> {
    const { shot, due } = of;
    const first = due && (!shot || !of.covered || of !== ledger || due.known > of.known);
    const written = first || !shot ? 0 : await records.protect(base, shot);
    if (shot && written > 0) {
      of.looked = of.complete = false;
      count(of, shot, written);
      return 'on';
    }
    if (of.due) return write(of, of === ledger ? moment() : of.due, base);
    if (!shot) return 'done';
    if (await records.prove(base)) return 'on';
    if (!of.looked) {
      of.looked = await look(of, shot, base);
      if (of.looked) return 'on';
      if (of === ledger && !of.dirty) say('saving');
      return 'lost';
    }
    if (!of.complete) {
      complete(of, shot);
      return 'on';
    }
    return (await records.improve(base, shot)) ? 'on' : 'done';
  }

  function count(of: Ledger, shot: Snapshot, written: number) {
    if (of !== ledger) return;
    of.done += written;
    const total = of.done + records.waiting(shot);
    progress.value = total > 0 ? { done: of.done, total } : null;
    weigh();
  }

  function complete(of: Ledger, shot: Snapshot) {
    of.complete = true;
    of.done = 0;
    attempts = 0;
    if (of === ledger) {
      progress.value = null;
      missing.value = records.missing(shot);
      if (!of.dirty) say(missing.peek().length > 0 ? 'missing' : 'saved');
    }
    onSaved(of.place);
  }

  function failed(of: Ledger, error: Error & { code?: string }) {
    of.due = null;
    if (of !== ledger) return;
    progress.value = null;
    const why = isFull(error)
      ? 'full'
      : error.code === 'no-storage' || error.name === 'SecurityError'
        ? 'refused'
        : 'failed';
    say(why);
    onTrouble(why, error);
    // After a full storage or a conflict, only a change can help.
    if (why === 'full' || error.code === 'conflict') return;
    timer.start(Math.min(LONGEST_PAUSE, PAUSE * 2 ** attempts), save);
    attempts += 1;
  }

  async function write(of: Ledger, { now, shot, known }: Moment, base: Database): Promise<'on'> {
    of.due = null;
    of.dirty = false;
    of.since = performance.now();
    const { bytes, at } = shot.editing.save();
    of.next = { stamp: freshId(), editing: shot.editing, at };
    try {
      await writeState(base, shot, {
        stamp: of.next.stamp,
        bytes,
        videos: records.keyed(shot.videos),
        facts: of.facts,
      });
    } catch (error) {
      of.dirty = true;
      of.next = null;
      throw error;
    }
    shot.place.stamp = of.next.stamp;
    Object.assign(of, { shot, bytes, clean: now, base: of.next, next: null, looked: false, complete: false, known });
    shot.editing.trim(at);
    if (of === ledger) tell(of);
    onWritten(of.place);
    count(of, shot, 0);
    return 'on';
  }

  async function writeState(
    base: Database,
    { place: { id, created, stamp: before }, mirror, drawn, facts: known }: Snapshot,
    {
      stamp,
      bytes,
      videos,
      facts,
    }: { stamp: string; bytes: Uint8Array<ArrayBuffer>; videos: KeptVideo[]; facts: Ledger['facts'] },
  ) {
    const all = base.transaction(['projects', 'states', 'facts'], 'readwrite');
    const projects = all.objectStore('projects');
    const ids = known.map((fact) => fact.id);
    try {
      const found = await projects.get(id);
      // A missing project, possibly with the whole database, is not a conflict.
      if (typeof found?.stamp === 'string' && found.stamp !== before) throw conflict();
      const { name, tray } = mirror.present;
      // None of its files could be read. It is stored as deleted, so that it is in no list.
      const isBare = tray.length === 0 && name === '' && mirror.undos === 0;
      const refs = [...ids, ...videos.map(({ fileKey }) => fileKey)];
      const about = {
        ...(found?.held && { held: found.held }),
        id,
        name,
        created,
        changed: Date.now(),
        stamp,
        photos: tray.length,
        refs,
        gone: isBare ? Date.now() : null,
      };
      await adopt(all.objectStore('states'), refs);
      const fresh = known.filter((fact) => facts.get(fact.id) !== fact);
      const asked = [
        () => projects.put({ ...about, picture: found?.picture ?? null }),
        () => all.objectStore('states').put({ id, version: RECORD, stamp, bytes, facts: ids, videos }),
        ...(drawn.length > 0
          ? [() => all.objectStore('states').put({ id: drawnId(id), version: VERSION, drawn, facts: ids })]
          : []),
        ...fresh.map((fact) => () => all.objectStore('facts').put({ id: fact.id, fact })),
      ].map((ask) => {
        const answer = ask();
        // If a later request throws, this promise is not awaited.
        answer.catch(() => {});
        return answer;
      });
      await Promise.all([...asked, all.done]);
      for (const fact of fresh) facts.set(fact.id, fact);
    } catch (error) {
      // The end of the transaction repeats the error.
      all.done.catch(() => {});
      abort(all);
      throw error;
    }
  }

  /**
   * Reads the state back, and checks that all keys that it refers to exist.
   * @returns whether everything exists; missing data will be written
   */
  async function look(of: Ledger, { place: { id, stamp }, facts, videos }: Snapshot, base: Database): Promise<boolean> {
    const all = base.transaction(['projects', 'states', 'facts', 'photos']);
    const [project, state, known, there] = await Promise.all([
      all.objectStore('projects').get(id),
      all.objectStore('states').get(id),
      all.objectStore('facts').getAllKeys(),
      all.objectStore('photos').getAllKeys(),
    ]);
    if (project && project.stamp !== stamp) throw conflict();
    const spoilt =
      project === undefined ||
      state?.stamp !== stamp ||
      (of.bytes ? !isEqual(state.bytes, of.bytes) : !hasDocument(state));
    const [factKeys, photoKeys] = [new Set(known), new Set(there)];
    const unknown = facts.filter((fact) => !factKeys.has(fact.id));
    for (const fact of unknown) of.facts.delete(fact.id);
    if (of === ledger && (spoilt || unknown.length > 0)) of.due = moment();
    const lost = records.lose(
      [...facts.map((fact) => fact.id), ...records.keyed(videos).map(({ fileKey }) => fileKey)].filter(
        (key) => !photoKeys.has(key),
      ),
    );
    return !of.due && lost === 0;
  }

  /** Whether replacing this project loses no data. */
  function isSafe() {
    if (store.tray.peek().length === 0 && ledger.place.stamp === '') return true;
    return (
      store.mirror.peek() === ledger.inFile ||
      (!ledger.dirty && (status.peek() === 'saved' || status.peek() === 'empty'))
    );
  }

  /** Records that the current state was exported to a file. */
  function filed() {
    ledger.inFile = store.mirror.peek();
  }
}

function isEqual(one: unknown, other: Uint8Array) {
  if (!isBytes(one) || one.length !== other.length) return false;
  for (let i = 0; i < one.length; i += 1) if (one[i] !== other[i]) return false;
  return true;
}

/** Aborts the transaction, because its earlier requests would be written otherwise. */
function abort(transaction: { abort: () => void }) {
  try {
    transaction.abort();
  } catch {
    // It is over already.
  }
}

function conflict() {
  return failure('conflict', 'Another tab has changed this project.');
}
