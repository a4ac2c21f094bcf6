/**
 * Shared code of all pool workers: they report that they are ready, and run one job at a time. `pool.ts` replaces
 * hanging workers.
 */

import { describe } from './protocol.ts';
import type { Table } from './protocol.ts';

/** Reports that a job downloads a file or paints, so that it gets the longest time limit (`time-limits.ts`). */
export type Slow = () => void;

/** Result of an operation, and the buffers to transfer. */
export type Answer<Ok> = { ok: Ok; transfer?: Transferable[] };
/** A function for each operation of a table. */
export type Work<Ops extends Table> = {
  [Op in keyof Ops]: (args: Ops[Op]['args'], slow: Slow) => Promise<Answer<Ops[Op]['ok']>>;
};
type Order<Ops extends Table> = { id: number; op: keyof Ops; args: Ops[keyof Ops]['args'] };

/**
 * @param work does one job
 * @param start handles the initial message, before the first job
 */
export function serveJobs<Ops extends Table, Start = never>(
  work: <Op extends keyof Ops>(
    op: Op,
    args: Ops[Op]['args'],
    slow: Slow,
  ) => Promise<Answer<Ops[Op]['ok']> & { memory?: number }>,
  start?: (told: Start) => void,
) {
  globalThis.onmessage = async ({ data }: MessageEvent<Order<Ops> | { start: Start }>) => {
    if ('start' in data) {
      start?.(data.start);
      return;
    }
    const { id, op, args } = data;
    try {
      const { ok, transfer = [], memory = 0 } = await work(op, args, () => postMessage({ id, slow: true }));
      postMessage({ id, ok, memory }, { transfer });
    } catch (error) {
      postMessage({ id, error: describe(error), memory: 0 });
    }
  };
  postMessage({ id: 0 });
}
