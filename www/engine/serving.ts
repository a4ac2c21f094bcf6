/**
 * Shared code of all pool workers: they report that they are ready, run one job at a time, and report the expected
 * duration of each part. `pool.ts` replaces hanging workers.
 */

import { describe } from './protocol.ts';
import type { Table } from './protocol.ts';

/**
 * `expects`: milliseconds of work on the reference machine (`measured.ts`). `waits`: maximum milliseconds for external
 * work, such as reading a file.
 */
export type Tell = { expects: (ms: number) => void; waits: (ms: number) => void };

/** Milliseconds for a download and its compilation: the largest model on a slow connection. */
export const LOADING = 120_000;
/** Milliseconds for the browser to read or store a blob. */
export const STORING = 30_000;
/** Minimum speed of a slow disk or network drive, in bytes per millisecond. */
const BYTES_A_MS = 500;

/** maximum milliseconds for reading it */
export function readingOf({ size }: Blob): number {
  return STORING + size / BYTES_A_MS;
}

/** Result of an operation, and the buffers to transfer. */
export type Answer<Ok> = { ok: Ok; transfer?: Transferable[] };
/** A function for each operation of a table. */
export type Work<Ops extends Table> = {
  [Op in keyof Ops]: (args: Ops[Op]['args'], tell: Tell) => Promise<Answer<Ops[Op]['ok']>>;
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
    tell: Tell,
  ) => Promise<Answer<Ops[Op]['ok']> & { memory?: number }>,
  start?: (told: Start) => void,
) {
  globalThis.onmessage = async ({ data }: MessageEvent<Order<Ops> | { start: Start }>) => {
    if ('start' in data) {
      start?.(data.start);
      return;
    }
    const { id, op, args } = data;
    const tell = {
      expects: (ms: number) => postMessage({ id, expects: ms }),
      waits: (ms: number) => postMessage({ id, waits: ms }),
    };
    try {
      const { ok, transfer = [], memory = 0 } = await work(op, args, tell);
      postMessage({ id, ok, memory }, { transfer });
    } catch (error) {
      postMessage({ id, error: describe(error), memory: 0 });
    }
  };
  postMessage({ id: 0 });
}
