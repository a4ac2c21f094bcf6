/**
 * Warm-up. Browsers compile wasm to slow code first, and optimise frequently used code later. Idle workers read a
 * synthetic photo and draw pages with it, so that the user's first photos run on optimised code.
 */

import { Priority } from './queue.ts';
import type { Run } from './pool.ts';
import type { PageDocument } from './types.ts';

/** Number of photos in sequence. A worker is never busy for longer than with one of them. */
const ROUNDS = 24;

/** @param run passes a job to the pool @param workers number of workers with separate code */
export function createWarming(run: Run, workers = 1) {
  const over = new AbortController();

  return {
    warm,
    /** Ends the warm-up for real work. The current job ends shortly after. */
    stop: () => over.abort(),
  };

  /**
   * @param documents pages whose photos are all called `warm`
   * @returns when the code is optimised, or the user needs the workers
   */
  async function warm(documents: readonly PageDocument[]): Promise<void> {
    await Promise.all(Array.from({ length: workers }, () => warmOne(documents)));
  }

  /** One worker at a time is busy with it, so that several are of several workers. */
  async function warmOne(documents: readonly PageDocument[]) {
    for (let round = 0; round < ROUNDS && !over.signal.aborted; round += 1) {
      const document = JSON.stringify(documents[round % documents.length]);
      await run({ op: 'warm', args: { document }, priority: Priority.REST, signal: over.signal }).catch(() =>
        over.abort(),
      );
    }
  }
}
