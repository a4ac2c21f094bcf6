/**
 * A worker of the pool: one wasm instance, one job at a time, and the photos of the last jobs.
 */

import initCore, { Studio } from '../pkg/inkpanel.js';
import { createLru } from './lru.ts';
import { createOperations } from './operations.ts';
import { STORING, serveJobs } from './serving.ts';

let started: Promise<{ studio: Studio; operations: ReturnType<typeof createOperations> }> | undefined;

serveJobs(async (op, args, tell) => {
  if (op === 'start') {
    started = start(args);
    // The first job reports it, to whoever asked for that job.
    started.catch(() => {});
    return { ok: null };
  }
  tell.waits(STORING);
  const { studio, operations } = await (started as NonNullable<typeof started>);
  const answer = await operations[op](args, tell);
  return { ...answer, memory: studio.memory() };
});

async function start({ module, budget }: { module: WebAssembly.Module; budget: number }) {
  await initCore({ module_or_path: module });
  const studio = new Studio();
  return { studio, operations: createOperations(studio, createLru(budget)) };
}
