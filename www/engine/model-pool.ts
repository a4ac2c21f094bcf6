/** A pool of one worker with a model. It starts with its first job, and the scheduler decides when it ends. */

import { STORED_AFTER } from './kept.ts';
import { createPool } from './pool.ts';
import type { Job, Pool, Run } from './pool.ts';
import type { Table } from './protocol.ts';
import type { Lane, Scheduler } from './scheduler.ts';

export type ModelPool<Ops extends Table> = {
  /** Runs a job; use it within `use`. */
  run: Run<Ops>;
  /** Keeps the model in memory during some work. */
  use: <T>(work: () => Promise<T>, options?: { lane?: Lane; signal?: AbortSignal }) => Promise<T>;
  dispose: () => void;
};

export function createModelPool<Ops extends Table>(scheduler: Scheduler, spawn: () => Worker): ModelPool<Ops> {
  let pool: Pool<Ops> | undefined;
  const ticket = scheduler.createTicket({ unload, storing: STORED_AFTER });
  return { run, use: ticket.use, dispose: ticket.free };

  async function run<Op extends keyof Ops>(job: Job<Ops, Op>): Promise<Ops[Op]['ok']> {
    const isNew = !pool;
    pool ??= createPool<Ops>({ size: 1, spawn });
    const result = await pool.run(job);
    if (isNew) ticket.made();
    return result;
  }

  function unload() {
    pool?.dispose();
    pool = undefined;
  }
}
