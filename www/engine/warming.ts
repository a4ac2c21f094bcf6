/**
 * Browsers compile wasm twice: at once, to code that is slow, and what is used much a second time, to code that is fast. A
 * made-up photo is read and drawn on pages while nobody waits, so that the first photos of a person find fast code.
 */

import { Priority } from './queue.ts';
import type { Run } from './pool.ts';
import type { PageDocument } from './types.ts';

/** Photos read one after the other; a worker is never busy for longer than with one of them. */
const ROUNDS = 24;

/** @param run gives a job to the pool @param workers that have code of their own */
export function createWarming(run: Run, workers = 1) {
  const over = new AbortController();

  return {
    warm,
    /** There is real work: what is under way ends by itself, in a moment. */
    stop: () => over.abort(),
  };

  /**
   * @param documents pages whose photos are all called `warm`
   * @returns when the code is fast, or somebody needs it as it is
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
