/**
 * A pool of workers that each do one job at a time.
 *
 * - Jobs wait in priority order; a newer job overtakes an older one of the same key, waiting or running.
 * - An aborted job leaves the queue at once. A running job cannot be interrupted, because wasm does not receive
 *   messages. For long jobs (files, large photos: `Priority.PAGE`) its worker is replaced; otherwise its result is
 *   dropped.
 * - Each operation has a constant time limit (`time-limits.ts`). A worker without a result in time hangs. Time in which
 *   the device sleeps does not count.
 * - A worker that traps, crashes or hangs is terminated and replaced. The job is tried once more on a fresh worker, with
 *   twice the time; when that fails too the job rejects with `worker-lost`, naming its photo.
 * - wasm memory never shrinks: an idle worker whose memory is above the high-water mark is replaced. In idle pools the
 *   lower mark applies.
 */

import { TRAP, cancelled, failure, lost } from './protocol.ts';
import { Priority, createQueue } from './queue.ts';
import { after, timeLimit } from './scheduler.ts';
import { LONG, limitOf } from './time-limits.ts';
import type { Operations, Reply, Sign, Table } from './protocol.ts';

/**
 * `promoted`: when it resolves, the job becomes as urgent as a panel of the visible page. `photo` is the name to blame; `holds` are the photo keys that the job needs and leaves in the worker
 */
export type Job<Ops extends Table = Operations, Op extends keyof Ops = keyof Ops> = {
  op: Op;
  args: Ops[Op]['args'];
  transfer?: Transferable[];
  priority: number;
  key?: string;
  signal?: AbortSignal;
  promoted?: Promise<unknown>;
  photo?: string;
  holds?: string[];
};

/** Returns the result of an operation. */
export type Run<Ops extends Table = Operations> = <Op extends keyof Ops>(job: Job<Ops, Op>) => Promise<Ops[Op]['ok']>;
export type Pool<Ops extends Table = Operations> = {
  run: Run<Ops>;
  spare: (count: number) => void;
  hold: (on: boolean) => void;
  dispose: () => void;
  size: number;
};

type Entry = Omit<Job, 'op' | 'args'> & {
  op: PropertyKey;
  args: unknown;
  resolve: (value: unknown) => void;
  reject: (error: Error) => void;
  tries: number;
  over: boolean;
  release: () => void;
};
/** `here`: the worker is ready. */
type Slot = {
  worker: Worker;
  entry: Entry | null;
  held: Set<string>;
  id: number;
  relax: () => void;
  dead: boolean;
  here: boolean;
};

/** Maximum milliseconds until a worker is ready. Its script may arrive over a slow connection. */
const STARTING = 30_000;
/** Factor of the time limit for the last attempt, because a device may become slower. */
const LAST_CHANCE = 2;
/**
 * Grace period of an aborted job in milliseconds, so that an almost finished job costs no worker. Delays below 100 ms
 * are not noticeable.
 */
const GRACE = 50;
const HIGH_WATER = 512 * 2 ** 20;

export function createPool<Ops extends Table = Operations>({
  size,
  spawn,
  highWater = HIGH_WATER,
  restWater = highWater,
}: {
  size: number;
  spawn: () => Worker;
  highWater?: number;
  restWater?: number;
}): Pool<Ops> {
  const queue: ReturnType<typeof createQueue<Entry>> = createQueue();
  const slots: Slot[] = [];
  let [nextId, reserved, held, closed] = [1, 0, false, false];

  for (let i = 0; i < size; i += 1) slots.push(open({}));
  return { run, spare, hold, dispose, size };

  /** Keeps this many workers free of low-priority work while other code needs the cores. */
  function spare(count: number) {
    reserved = Math.min(count, size - 1);
    dispatch();
  }

  /** Holds low-priority work until the page is drawn. A worker that reads a large photo would be available too late. */
  function hold(on: boolean) {
    held = on;
    dispatch();
  }

  /** @returns the worker's answer */
  function run<Op extends keyof Ops>(job: Job<Ops, Op>): Promise<Ops[Op]['ok']> {
    if (closed) return Promise.reject(failure('disposed', 'The engine was disposed of.'));
    if (job.signal?.aborted) return Promise.reject(cancelled());
    return new Promise((resolve, reject) => {
      const abort = () => {
        drop(entry);
        if (entry.priority === Priority.PAGE) after(GRACE, () => stop(entry));
      };
      const entry: Entry = {
        ...job,
        resolve: resolve as (value: unknown) => void,
        reject,
        tries: 0,
        over: false,
        release: () => job.signal?.removeEventListener('abort', abort),
      };
      job.signal?.addEventListener('abort', abort, { once: true });
      job.promoted?.then(() => promote(entry));
      const waiting = queue.push(entry);
      if (waiting) drop(waiting);
      for (const slot of slots) {
        if (entry.key !== undefined && slot.entry?.key === entry.key) drop(slot.entry);
      }
      dispatch();
    });
  }

  /** Moves a waiting job to the front. A running job stays. */
  function promote(entry: Entry) {
    if (!queue.remove(entry)) return;
    entry.priority = Priority.PANEL;
    queue.push(entry);
    dispatch();
  }

  /** Cancels a job wherever it is. */
  function drop(entry: Entry) {
    queue.remove(entry);
    settle(entry, () => entry.reject(cancelled()));
  }

  /** Replaces the worker of an unwanted job. Its photos are loaded again when needed. */
  function stop(entry: Entry) {
    const slot = slots.find((other) => other.entry === entry);
    if (slot && !closed) lose(slot);
  }

  function settle(entry: Entry, how: () => void) {
    if (entry.over) return;
    entry.over = true;
    entry.release();
    how();
  }

  function dispatch() {
    for (const slot of slots) {
      if (slot.entry || queue.length === 0) continue;
      if (held && queue.urgency > Priority.PAGE) return;
      const idle = Math.max(reserved, queue.crowded && size > 1 ? 1 : 0);
      if (queue.urgency > Priority.PAGE && slots.filter(({ entry }) => entry).length >= size - idle) return;
      const entry = queue.take((other) => (other.holds ?? []).filter((key) => slot.held.has(key)).length);
      if (entry) start(slot, entry);
    }
  }

  function start(slot: Slot, entry: Entry) {
    if (slot.dead) open(slot);
    slot.entry = entry;
    slot.id = nextId;
    nextId += 1;
    for (const key of entry.holds ?? []) slot.held.add(key);
    wait(slot, slot.here ? limitOf(entry.op) : STARTING);
    try {
      slot.worker.postMessage({ id: slot.id, op: entry.op, args: entry.args }, entry.transfer ?? []);
    } catch (error) {
      finish(slot);
      settle(entry, () => entry.reject(error as Error));
      dispatch();
    }
  }

  /** Sets the time limit of a worker. */
  function wait(slot: Slot, ms: number) {
    slot.relax();
    const last = slot.entry && !mayTryAgain(slot.entry);
    slot.relax = timeLimit(slot.here && last ? LAST_CHANCE * ms : ms, () => lose(slot));
  }

  function hear(slot: Slot, news: Reply | Sign) {
    if (!slot.here) {
      slot.here = true;
      if (slot.entry) wait(slot, limitOf(slot.entry.op));
    }
    if (!slot.entry || news.id !== slot.id) return;
    if ('slow' in news) wait(slot, LONG);
    else answer(slot, news);
  }

  function answer(slot: Slot, reply: Reply) {
    if (reply.error?.code === TRAP) {
      lose(slot);
      return;
    }
    const entry = finish(slot);
    const { error } = reply;
    if (error) settle(entry, () => entry.reject(failure(error.code, error.message, { photo: entry.photo })));
    else settle(entry, () => entry.resolve(reply.ok));
    if (reply.memory > (queue.length === 0 ? restWater : highWater)) open(slot);
    dispatch();
  }

  function finish(slot: Slot): Entry {
    const entry = slot.entry as Entry;
    slot.relax();
    slot.entry = null;
    return entry;
  }

  /** Replaces a worker that died in the middle of a job, or between two. */
  function lose(slot: Slot) {
    const entry = slot.entry && finish(slot);
    open(slot);
    if (entry && !entry.over) {
      const again = mayTryAgain(entry);
      entry.tries += 1;
      // Retry on the fresh worker.
      if (again) start(slot, entry);
      else settle(entry, () => entry.reject(lost(entry.photo)));
    }
    dispatch();
  }

  /** Jobs with transferred buffers cannot be retried, because the buffers are lost with the worker. */
  function mayTryAgain(entry: Entry) {
    return entry.tries === 0 && !entry.transfer?.length;
  }

  /** Starts a new worker in a slot. */
  function open(slot: Partial<Slot>): Slot {
    slot.worker?.terminate();
    const worker = spawn();
    const filled = Object.assign(slot, {
      worker,
      entry: null,
      held: new Set(),
      id: 0,
      relax: () => {},
      dead: false,
      here: false,
    }) as Slot;
    const mine = () => filled.worker === worker && !closed;
    worker.onmessage = (event) => mine() && hear(filled, event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      if (!mine()) return;
      // An idle worker is replaced when it is next needed. Otherwise, a worker that cannot load would be replaced
      // forever.
      if (filled.entry) lose(filled);
      else filled.dead = true;
    };
    worker.onmessageerror = () => mine() && lose(filled);
    return filled;
  }

  function dispose() {
    closed = true;
    const left = [...queue.clear(), ...slots.flatMap((slot) => slot.entry ?? [])];
    for (const slot of slots) {
      slot.relax();
      slot.worker.terminate();
    }
    for (const entry of left) settle(entry, () => entry.reject(cancelled()));
  }
}
