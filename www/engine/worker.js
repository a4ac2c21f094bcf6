// @ts-check
/**
 * A worker of the pool: one wasm instance, one job at a time, and the photos of the last jobs.
 */

import initCore, { Studio } from '../pkg/inkpanel.js';
import { createLru } from './lru.js';
import { createOperations } from './operations.js';
import { describe } from './protocol.js';

/** @typedef {import('./protocol.js').Request} Request */

/** @type {Promise<{ studio: Studio, operations: ReturnType<typeof createOperations> }> | undefined} */
let started;

/** @param {MessageEvent<Request>} event */
globalThis.onmessage = async (event) => {
  const { id, op, args } = event.data;
  if (op === 'start') {
    started = start(args);
    // The first job reports it, to whoever asked for that job.
    started.catch(() => {});
    return;
  }
  let memory = 0;
  try {
    const { studio, operations } = await /** @type {NonNullable<typeof started>} */ (started);
    const { ok, transfer } = await operations[op](args);
    memory = studio.memory();
    postMessage({ id, ok, memory }, { transfer });
  } catch (error) {
    postMessage({ id, error: describe(error), memory });
  }
};

/** @param {{ module: WebAssembly.Module, budget: number }} args */
async function start({ module, budget }) {
  await initCore({ module_or_path: module });
  const studio = new Studio();
  return { studio, operations: createOperations(studio, createLru(budget)) };
}
