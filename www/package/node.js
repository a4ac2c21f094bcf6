// @ts-check
/**
 * The engine in Node. It works as in a browser, but its workers are threads. It has no codecs of browsers, so it cannot
 * read videos, AVIF and HEIC.
 */

import { availableParallelism } from 'node:os';
import { Worker as Thread } from 'node:worker_threads';
import { createEngine as create } from './index.js';
import { readFromDisk } from './node-disk.js';

/** A thread with the interface of a browser worker, as far as the engine uses it. */
class ThreadWorker {
  /** @type {((event: { data: unknown }) => void) | null} */
  onmessage = null;
  /** @type {((event: { message: string, error: unknown, preventDefault: () => void }) => void) | null} */
  onerror = null;
  /** @type {(() => void) | null} */
  onmessageerror = null;
  /** @type {Thread} */
  #thread;

  /** @param {URL} module @param {{ name?: string }} [options] */
  constructor(module, { name } = {}) {
    this.#thread = new Thread(new URL('./node-thread.js', import.meta.url), { name, workerData: String(module) });
    this.#thread.on('message', (data) => this.onmessage?.({ data }));
    this.#thread.on('messageerror', () => this.onmessageerror?.());
    this.#thread.on('error', (error) =>
      this.onerror?.({ message: String(error?.message ?? error), error, preventDefault: () => {} }),
    );
  }

  /** @param {unknown} message @param {any[]} [transfer] */
  postMessage(message, transfer) {
    this.#thread.postMessage(message, transfer);
  }

  terminate() {
    void this.#thread.terminate();
  }
}

readFromDisk();
// The engine starts its workers as a browser does.
Object.assign(globalThis, { Worker: globalThis.Worker ?? ThreadWorker });

export * from './index.js';

/** @param {Parameters<typeof create>[0]} [options] as in a browser; a process ends when `dispose` was called */
export function createEngine(options) {
  return create({ workers: availableParallelism(), ...options });
}
