/**
 * Decides when work starts, so that the visible page never waits for other work. There are three lanes:
 *
 * - `visible`: the page on the screen. It starts at once, and the app holds the other lanes meanwhile (`hold`).
 * - `requested`: work that the user waits for. It starts when the page is drawn.
 * - `background`: all other work. It starts when the page was also at rest for a moment.
 *
 * A task that has started sends jobs to workers, whose priorities are in `queue.ts`. Models take about a hundred
 * megabytes, so a task also needs a ticket (`createTicket`) before it loads one.
 *
 * Product code has no other timers. It uses `after`, `createTimer`, `pause` and `timeLimit` only for:
 *
 * - gestures: a long press, and the click after it (`pointing`, `list-drag`, `card-drag`);
 * - previews of input at rest: hover previews, hints, file sizes, sheets, plans of videos, the designer, a resized page,
 *   the place of a long text;
 * - collected updates: autosave, imported photos, failed files, missing photos, pieces of long lists;
 * - deadlines: of workers, files, videos, frames, faces for the first page, a new app version, an aborted job;
 * - later steps: notes that close, released file addresses, cached models, another try to store a photo.
 */

import { cancelled } from './protocol.ts';

/** In order of urgency. */
const LANES = ['visible', 'requested', 'background'] as const;
export type Lane = (typeof LANES)[number];
export type Scheduler = ReturnType<typeof createScheduler>;
export type Ticket = ReturnType<Scheduler['createTicket']>;

/**
 * Condition for the start of a task:
 *
 * - `rest`: milliseconds since the page was drawn, for the background lane;
 * - `delay`: milliseconds since the request;
 * - `latest`: time of `performance.now()` at which it starts even if the page is busy.
 */
export type Condition = { rest?: number; delay?: number; latest?: number; signal?: AbortSignal };

/** Milliseconds of rest after a page was drawn. A user who shuffles quickly needs the workers. */
const REST = 350;
/** Maximum wait in milliseconds, so that background work also ends during continuous shuffling. */
const LONGEST_WAIT = 6_000;
/** Maximum milliseconds of one hold, in case a page cannot be drawn. */
const LONGEST_HOLD = 3_000;
/** Milliseconds that a model stays in memory after its last use. */
const LINGER = 10_000;

type Waiting = { lane: Lane; from: number; rest: number; latest: number; start: () => void };
/** `stored`: time when the worker has stored its model. */
type Holder = { lane: Lane; busy: number; loaded: boolean; stored: number; unload: () => void };
type Asking = { holder: Holder; lane: Lane; start: () => void };

export function createScheduler() {
  const waiting: Waiting[] = [];
  const asking: Asking[] = [];
  const holders: Set<Holder> = new Set();
  const onHold: Set<(on: boolean) => void> = new Set();
  const [waking, holding, freeing] = [createTimer(), createTimer(), createTimer()];
  let held = false;
  let drawn = Number.NEGATIVE_INFINITY;

  return { hold, follow, turn, background, createTicket };

  /** Holds the other lanes while the visible page is planned or drawn. */
  function hold(on: boolean) {
    if (on === held) return;
    held = on;
    drawn = performance.now();
    if (on) holding.start(LONGEST_HOLD, () => hold(false));
    else holding.stop();
    for (const call of onHold) call(on);
    wake();
  }

  /** @param call receives each change of the hold @returns ends it */
  function follow(call: (on: boolean) => void): () => void {
    onHold.add(call);
    return () => void onHold.delete(call);
  }

  /** Resolves when a task of the lane may start. Rejects if the signal aborts before. */
  function turn(lane: Lane, { rest = REST, delay = 0, latest, signal }: Condition = {}): Promise<void> {
    if (signal?.aborted) return Promise.reject(cancelled());
    if (lane === 'visible') return Promise.resolve();
    return new Promise((resolve, reject) => {
      const now = performance.now();
      const entry: Waiting = {
        lane,
        from: now + delay,
        rest: lane === 'background' ? rest : 0,
        latest: latest ?? now + delay + LONGEST_WAIT,
        start: () => {
          signal?.removeEventListener('abort', abort);
          resolve();
        },
      };
      const abort = () => {
        remove(waiting, entry);
        reject(cancelled());
      };
      signal?.addEventListener('abort', abort, { once: true });
      waiting.push(entry);
      wake();
    });
  }

  /** Runs a task in the background lane. The signal cancels it before its start. */
  function background(task: () => unknown, condition?: Condition) {
    turn('background', condition).then(task, () => {});
  }

  /** Sets the alarm for the first task that is due. Tasks never start in the call that requests them. */
  function wake() {
    const dues = waiting.map(dueOf).filter((due) => due < Infinity);
    waking.stop();
    if (dues.length > 0) waking.start(Math.max(0, Math.min(...dues) - performance.now()), startNext);
  }

  function dueOf({ from, rest, latest }: Waiting): number {
    return Math.min(Math.max(from, latest), held ? Infinity : Math.max(from, drawn + rest));
  }

  /** Starts one task. The next one starts in another task of the event loop, so that the app stays responsive. */
  function startNext() {
    const now = performance.now();
    // Timers may fire a fraction of a millisecond early.
    const [next] = inOrder(waiting.filter((entry) => dueOf(entry) <= now + 1));
    if (next) {
      remove(waiting, next);
      next.start();
    }
    wake();
  }

  /**
   * A ticket for the memory of a model. One model is in memory at a time. An idle model is unloaded when another one is
   * needed, and some time after its last use. A model that the user waits for is not unloaded for background work.
   * @param options `unload` frees the memory. `linger`: milliseconds after the last use, `Infinity` keeps the model;
   *   `storing`: milliseconds that a downloaded model stays at least, so that the browser stores its compiled code
   */
  function createTicket({
    unload,
    linger = LINGER,
    storing = 0,
  }: {
    unload: () => void;
    linger?: number;
    storing?: number;
  }) {
    const holder: Holder = { lane: 'background', busy: 0, loaded: false, stored: 0, unload: free };
    const resting = createTimer();
    return { use, made, free };

    /**
     * Runs work with the model in memory.
     * @param options `expected`: another use follows soon, so the model is not unloaded after a time
     */
    async function use<T>(
      work: () => Promise<T>,
      { lane = 'background', signal, expected = false }: { lane?: Lane; signal?: AbortSignal; expected?: boolean } = {},
    ): Promise<T> {
      await memory(holder, lane, signal);
      resting.stop();
      try {
        return await work();
      } finally {
        holder.busy -= 1;
        if (holder.busy === 0 && holder.loaded && !expected && linger < Infinity)
          resting.start(Math.max(linger, holder.stored - performance.now()), free);
        grant();
      }
    }

    /** Notes that the model was downloaded just now. */
    function made() {
      holder.stored = performance.now() + storing;
    }

    /** Unloads the model now. */
    function free() {
      resting.stop();
      holders.delete(holder);
      Object.assign(holder, { loaded: false, stored: 0 });
      unload();
      grant();
    }
  }

  /** Waits for the memory of a model. */
  function memory(holder: Holder, lane: Lane, signal?: AbortSignal): Promise<void> {
    if (signal?.aborted) return Promise.reject(cancelled());
    return new Promise((resolve, reject) => {
      const entry: Asking = {
        holder,
        lane,
        start: () => {
          signal?.removeEventListener('abort', abort);
          Object.assign(holder, { lane, loaded: true, busy: holder.busy + 1 });
          holders.add(holder);
          resolve();
        },
      };
      const abort = () => {
        remove(asking, entry);
        reject(cancelled());
      };
      signal?.addEventListener('abort', abort, { once: true });
      asking.push(entry);
      grant();
    });
  }

  /** Gives the memory to the most urgent request. Requests for another model wait until the current one is idle. */
  function grant() {
    freeing.stop();
    const [first] = inOrder(asking);
    if (!first) return;
    const others = [...holders].filter((other) => other !== first.holder);
    const stored = Math.max(0, ...others.map((other) => other.stored));
    if (others.some(({ busy, lane }) => busy > 0 || (lane !== 'background' && first.lane === 'background'))) return;
    if (stored > performance.now()) {
      freeing.start(stored - performance.now(), grant);
      return;
    }
    remove(asking, first);
    for (const other of others) holders.delete(other);
    first.start();
    for (const other of others) other.unload();
    grant();
  }
}

function remove<T>(list: T[], entry: T) {
  const at = list.indexOf(entry);
  if (at >= 0) list.splice(at, 1);
}

/** @returns the most urgent first, and the earlier one of equals */
function inOrder<T extends { lane: Lane }>(list: readonly T[]): T[] {
  return [...list].sort((a, b) => LANES.indexOf(a.lane) - LANES.indexOf(b.lane));
}

/** Calls a function after some milliseconds. @returns cancels the call */
export function after(ms: number, run: () => void): () => void {
  const timer = setTimeout(run, ms);
  return () => clearTimeout(timer);
}

/** One delayed call at a time. A new call replaces the pending one. */
export function createTimer() {
  let cancel: (() => void) | undefined;
  return {
    start(ms: number, run: () => void) {
      cancel?.();
      cancel = after(ms, () => {
        cancel = undefined;
        run();
      });
    },
    stop() {
      cancel?.();
      cancel = undefined;
    },
    /** Whether a call is pending. */
    get runs() {
      return cancel !== undefined;
    },
  };
}

/** Resolves in another task, so that the browser can draw and the user can act. */
export function nextTask(): Promise<void> {
  return pause(0);
}

/** Resolves after some milliseconds. */
export function pause(ms: number): Promise<void> {
  return new Promise((resolve) => void after(ms, resolve));
}

/** Number of parts of a time limit. */
const PARTS = 6;

/**
 * A time limit that ignores the time when the device sleeps or the tab is frozen. After a freeze timers fire late and
 * all at once, although no work was possible. So the limit is cut into parts that begin one after the other.
 * @param limit ms
 * @param over called after the limit
 * @returns ends the limit; call it when the work is done
 */
export function timeLimit(limit: number, over: () => void): () => void {
  const timer = createTimer();
  const next = (left: number) => timer.start(limit / PARTS, () => (left > 1 ? next(left - 1) : over()));
  next(PARTS);
  return timer.stop;
}
