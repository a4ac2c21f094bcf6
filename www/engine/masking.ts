/**
 * Subject masks of photos, by a model in a separate worker. The worker and the model are loaded with the first call and
 * unloaded some time after the last. The model is an optional part of the site.
 *
 * Detection takes one to two seconds at low priority. It runs in slices, and the worker pauses while a page is drawn
 * and a moment after, so that pages appear without delay.
 */

import { NET } from './subject-net.ts';
import { failure } from './protocol.ts';
import { Priority } from './queue.ts';
import { createRestingPool } from './resting-pool.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Masking, PhotoHandle } from './protocol.ts';

/** Minimum milliseconds between a drawn page and the next job for masks. */
const CALM = 1_000;
/** Maximum pause in milliseconds, so that detection also ends during continuous shuffling. */
const LONGEST_REST = 6_000;

export function createMasking(photos: ReturnType<typeof createPhotos>) {
  const pool = createRestingPool<Masking>(spawn);
  let looks = 0;
  let looking = 0;
  /** The worker is at one photo at a time. */
  let last: Promise<unknown> = Promise.resolve();
  /** When a page was drawn last. */
  let drawn = Number.NEGATIVE_INFINITY;
  return { masks: NET !== undefined, findMask, hold, rest, dispose: pool.dispose };

  /** While `on`, a page is drawn. */
  function hold(on: boolean) {
    drawn = performance.now();
    pool.hold(on);
  }

  /**
   * The subject mask of a photo in storage format.
   * @param id of an imported photo
   */
  async function findMask(id: string, call?: Call): Promise<string> {
    if (!NET) throw failure('net-missing', 'The net that finds subjects is not part of this site.');
    const { name, small, work } = photos.get(id);
    // The model's input has 320 pixels per side. The small copy is sufficient unless it is very elongated.
    const photo = Math.min(small.width, small.height) >= 320 ? small : work;
    const net = new URL(NET, document.baseURI).href;
    looking += 1;
    const found = last.then(() => look({ photo, net, name, call }));
    last = found.then(done, done);
    return found;
  }

  function done() {
    looking -= 1;
  }

  /** Unloads the model if it is idle. */
  function rest() {
    if (looking === 0) pool.rest();
  }

  async function look({ photo, net, name, call }: { photo: PhotoHandle; net: string; name: string; call?: Call }) {
    const args = { photo, net, look: (looks += 1) };
    const latest = performance.now() + LONGEST_REST;
    for (;;) {
      while (performance.now() < Math.min(latest, drawn + CALM) && !call?.signal?.aborted) await moment();
      const mask = await pool.run({ op: 'mask', args, photo: name, priority: Priority.REST, ...call });
      if (mask !== null) return mask;
    }
  }
}

function moment() {
  return new Promise((resolve) => setTimeout(resolve, CALM / 10));
}

function spawn() {
  return new Worker(new URL('./subject-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-subject' });
}
