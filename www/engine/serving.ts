/**
 * What all workers of a pool have in common: they say that they are there, take one job at a time, and before each part
 * of it say how long it may take (`pool.ts` replaces those that hang).
 */

import { describe } from './protocol.ts';

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

export function serveJobs(
  work: (op: string, args: any, tell: Tell) => Promise<{ ok: unknown; transfer?: Transferable[]; memory?: number }>,
) {
  globalThis.onmessage = async ({ data: { id, op, args } }: MessageEvent<{ id: number; op: string; args: any }>) => {
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
