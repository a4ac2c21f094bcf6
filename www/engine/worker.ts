/**
 * A worker of the pool: one wasm instance, one job at a time, and the photos of the last jobs.
 */

import initCore, { Studio } from '../pkg/inkpanel.js';
import { createLru } from './lru.ts';
import { createOperations } from './operations.ts';
import { STORING, serveJobs } from './serving.ts';
import type { Operations, Start } from './protocol.ts';
import type { Work } from './serving.ts';

/** Share of the photo memory for video frames before they are shown. */
const PASSING = 8;

let started: Promise<{ studio: Studio; operations: Work<Operations> }> | undefined;

serveJobs<Operations, Start>(
  async (op, args, tell) => {
    tell.waits(STORING);
    const { studio, operations } = await (started as NonNullable<typeof started>);
    const answer = await operations[op](args, tell);
    return { ...answer, memory: studio.memory() };
  },
  (told) => {
    started = start(told);
    // The first job reports the error.
    started.catch(() => {});
  },
);

async function start({ program, budget }: Start) {
  await initCore({ module_or_path: program });
  const studio = new Studio();
  return { studio, operations: createOperations(studio, createLru(budget), createLru(budget / PASSING)) };
}
