/**
 * What all workers of a pool have in common: they say that they are there, take one job at a time, and before each part
 * of it say how long it may take (`pool.ts` replaces those that hang).
 */

import { describe } from './protocol.ts';
import type { Table } from './protocol.ts';

/**
 * `expects`: work, in ms where it was measured (`measured.ts`); `waits`: at most so many ms for something that is not this
 * worker's to do, as reading a file.
 */
export type Tell = { expects: (ms: number) => void; waits: (ms: number) => void };

/** Milliseconds for what comes over the network, and is then compiled: the largest net on a slow line. */
export const LOADING = 120_000;
/** Milliseconds until the browser has given or taken a blob of its own. */
export const STORING = 30_000;
/** A file of a person may lie on a disk elsewhere that gives half a megabyte a second. */
const BYTES_A_MS = 500;

/** @returns ms that reading it may take */
export function readingOf({ size }: Blob): number {
  return STORING + size / BYTES_A_MS;
}

/** What an operation gives: its answer, and the buffers to hand over. */
export type Answer<Ok> = { ok: Ok; transfer?: Transferable[] };
/** A function for each operation of a table. */
export type Work<Ops extends Table> = {
  [Op in keyof Ops]: (args: Ops[Op]['args'], tell: Tell) => Promise<Answer<Ops[Op]['ok']>>;
};
type Order<Ops extends Table> = { id: number; op: keyof Ops; args: Ops[keyof Ops]['args'] };

/**
 * @param work does one job
 * @param start hears what a worker is told once, before its first job
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
