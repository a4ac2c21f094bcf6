/**
 * A pool of one worker with a model. It starts with its first job and ends some time after the last, because a model
 * takes a hundred megabytes.
 */

import { KEEPING } from './kept.ts';
import { createPool } from './pool.ts';
import type { Job, Pool, Run } from './pool.ts';
import type { Table } from './protocol.ts';

/** Milliseconds after the last job until the worker is terminated. */
const REST = 10_000;

export type RestingPool<Ops extends Table> = {
  run: Run<Ops>;
  hold: (on: boolean) => void;
  rest: () => void;
  dispose: () => void;
};

export function createRestingPool<Ops extends Table>(spawn: () => Worker): RestingPool<Ops> {
  let pool: Pool<Ops> | undefined;
  let resting: ReturnType<typeof setTimeout> | undefined;
  let running = 0;
  let opened = 0;
  return { run, hold: (on) => pool?.hold(on), rest, dispose };

  async function run<Op extends keyof Ops>(job: Job<Ops, Op>): Promise<Ops[Op]['ok']> {
    clearTimeout(resting);
    if (!pool) opened = performance.now();
    pool ??= createPool<Ops>({ size: 1, spawn });
    running += 1;
    try {
      return await pool.run(job);
    } finally {
      running -= 1;
      if (running === 0) resting = setTimeout(dispose, REST);
    }
  }

  /** Ends the idle worker early, unless it may still have to cache its model. */
  function rest() {
    if (performance.now() - opened > KEEPING) dispose();
  }

  function dispose() {
    clearTimeout(resting);
    pool?.dispose();
    pool = undefined;
  }
}
