/**
 * Subject masks of photos, by a model in a separate worker. The worker and the model are loaded with the first call and
 * unloaded some time after the last. The model is an optional part of the site.
 *
 * Detection takes one to two seconds in the background lane. It runs in slices, and the worker pauses while a page is
 * drawn and a moment after, so that pages appear without delay.
 */

import { NET } from './subject-net.ts';
import { createModelPool } from './model-pool.ts';
import { failure } from './protocol.ts';
import { Priority } from './queue.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Masking } from './protocol.ts';
import type { Scheduler } from './scheduler.ts';

/** Minimum milliseconds between a drawn page and the next slice. */
const CALM = 1_000;
/** Maximum pause before a slice in milliseconds, so that a detection also ends during continuous shuffling. */
const LONGEST_PAUSE = 2_000;

export function createMasking(photos: ReturnType<typeof createPhotos>, scheduler: Scheduler) {
  const pool = createModelPool<Masking>(scheduler, spawn);
  let looks = 0;
  /** One photo at a time. */
  let last: Promise<unknown> = Promise.resolve();
  return { masks: NET !== undefined, findMask, dispose: pool.dispose };

  /**
   * The subject mask of a photo in storage format.
   * @param id of an imported photo
   */
  async function findMask(id: string, call?: Call): Promise<string> {
    if (!NET) throw failure('net-missing', 'The net that finds subjects is not part of this site.');
    const { name, small, work } = photos.get(id);
    // The model's input has 320 pixels per side. The small copy is sufficient unless it is very elongated.
    const photo = Math.min(small.width, small.height) >= 320 ? small : work;
    const args = { photo, net: new URL(NET, document.baseURI).href, look: (looks += 1) };
    const find = async () => {
      for (;;) {
        const latest = performance.now() + LONGEST_PAUSE;
        await scheduler.turn('background', { rest: CALM, latest, signal: call?.signal });
        const mask = await pool.run({ op: 'mask', args, photo: name, priority: Priority.REST, ...call });
        if (mask !== null) return mask;
      }
    };
    const found = last.then(() => pool.use(find, call));
    last = found.catch(() => {});
    return found;
  }
}

function spawn() {
  return new Worker(new URL('./subject-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-subject' });
}
