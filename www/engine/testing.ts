/** Workers without threads, for the tests of the pool. */

import { Priority } from './queue.ts';
import { createScheduler } from './scheduler.ts';

/** Jobs that are their names, and whose answers are these. */
export type Named = Record<string, { args: string; ok: string }>;

/** Workers that answer on command of the test. */
export function fakeWorkers() {
  const workers: any[] = [];
  const spawn = () => {
    const worker = {
      /** @type {any} */ request: null,
      dead: false,
      postMessage(request: any) {
        this.request = request;
      },
      terminate() {
        this.dead = true;
      },
    };
    workers.push(worker);
    return worker as any;
  };
  const live = () => workers.filter((worker) => !worker.dead);
  const holding = (name: string) => live().find((worker) => worker.request?.args === name);
  const answer = (name: string, reply: object = { ok: name }) => {
    const worker = holding(name);
    const { id } = worker.request;
    worker.request = null;
    worker.onmessage({ data: { id, memory: 0, ...reply } });
  };
  /** Sends a progress report of a worker. */
  const tell = (name: string, sign: { slow: true }) => {
    const worker = holding(name);
    worker.onmessage({ data: { id: worker.request.id, ...sign } });
  };
  /** All workers report that they are ready. */
  const arrive = () => live().forEach((worker) => worker.onmessage({ data: { id: 0 } }));
  return { workers, spawn, live, holding, answer, tell, arrive };
}

export const job = (name: string, rest?: object) => ({ op: 'work', args: name, priority: Priority.VIEW, ...rest });
export const caught = (promise: Promise<any>) =>
  promise.then(
    () => 'done',
    (error) => error.code,
  );

/** A scheduler without delays. */
export function eagerScheduler() {
  const scheduler = createScheduler();
  const background: typeof scheduler.background = (task, { signal } = {}) =>
    scheduler.background(task, { rest: 0, signal });
  return { ...scheduler, background };
}
