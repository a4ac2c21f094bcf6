// @ts-check
/** Workers without threads, for the tests of the pool. */

import { Priority } from './queue.js';

/** Workers that answer when the test says so. */
export function fakeWorkers() {
  /** @type {any[]} */
  const workers = [];
  const spawn = () => {
    const worker = { /** @type {any} */ request: null, dead: false,
      /** @param {any} request */
      postMessage(request) { this.request = request; },
      terminate() { this.dead = true; } };
    workers.push(worker);
    return /** @type {any} */ (worker);
  };
  const live = () => workers.filter((worker) => !worker.dead);
  /** @param {string} name */
  const holding = (name) => live().find((worker) => worker.request?.args === name);
  /** @param {string} name @param {object} [reply] */
  const answer = (name, reply = { ok: name }) => {
    const worker = holding(name);
    const { id } = worker.request;
    worker.request = null;
    worker.onmessage({ data: { id, memory: 0, ...reply } });
  };
  /** What a worker says beside answers. @param {string} name @param {{ expects: number } | { waits: number }} sign */
  const tell = (name, sign) => {
    const worker = holding(name);
    worker.onmessage({ data: { id: worker.request.id, ...sign } });
  };
  /** All workers say that they are there. */
  const arrive = () => live().forEach((worker) => worker.onmessage({ data: { id: 0 } }));
  return { workers, spawn, live, holding, answer, tell, arrive };
}

/** @param {string} name @param {object} [rest] */
export const job = (name, rest) => ({ op: 'work', args: name, priority: Priority.VIEW, ...rest });
export const caught = (/** @type {Promise<any>} */ promise) => promise.then(() => 'done', (error) => error.code);
