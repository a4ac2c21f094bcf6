/**
 * A worker of the pool: one wasm instance, one job at a time, and the photos of the last jobs.
 */

import initCore, { Studio } from '../pkg/inkpanel.js';
import { createLru } from './lru.ts';
import { createOperations } from './operations.ts';
import { mentionsPainter, paintersLoader } from './painters.ts';
import { serveJobs } from './serving.ts';
import type { Operations, Start } from './protocol.ts';
import type { Work } from './serving.ts';

/** Share of the photo memory for video frames before they are shown. */
const PASSING = 8;

type Started = { studio: Studio; operations: Work<Operations>; loadPainters: ReturnType<typeof paintersLoader> };

let started: Promise<Started> | undefined;

serveJobs<Operations, Start>(
  async (op, args, slow) => {
    const { studio, operations, loadPainters } = await (started as NonNullable<typeof started>);
    if (mentionsPainter(args)) {
      slow();
      await loadPainters(args);
    }
    const answer = await operations[op](args, slow);
    return { ...answer, memory: studio.memory() };
  },
  (told) => {
    started = start(told);
    // The first job reports the error.
    started.catch(() => {});
  },
);

async function start({ program, budget }: Start): Promise<Started> {
  await initCore({ module_or_path: program });
  const studio = new Studio();
  return {
    studio,
    operations: createOperations(studio, createLru(budget), createLru(budget / PASSING)),
    loadPainters: paintersLoader(studio),
  };
}
