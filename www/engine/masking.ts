/**
 * Which part of a photo is its subject, by a net in a worker of its own. That, and all it needs, is loaded with the first call,
 * and given up a while after the last. The net is optional when the site is built.
 */

import { NET } from './subject-net.ts';
import { createPool } from './pool.ts';
import { failure } from './protocol.ts';
import { Priority } from './queue.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Pool } from './pool.ts';
import type { Masking } from './protocol.ts';

/** Milliseconds after the last photo until the net is given up: it takes a hundred megabytes. */
const REST = 10_000;

export function createMasking(photos: ReturnType<typeof createPhotos>) {
  let pool: Pool<Masking> | undefined;
  let resting: ReturnType<typeof setTimeout> | undefined;
  return { masks: NET !== undefined, findMask, dispose };

  /**
   * The subject of a photo, as it is kept.
   * @param id of an imported photo
   */
  async function findMask(id: string, call?: Call): Promise<string> {
    if (!NET) throw failure('net-missing', 'The net that finds subjects is not part of this site.');
    const { name, small, work } = photos.get(id);
    // The net looks at 320 pixels a side; the small copy has that many, if it is not very long.
    const photo = Math.min(small.width, small.height) >= 320 ? small : work;
    clearTimeout(resting);
    pool ??= createPool<Masking>({ size: 1, spawn });
    const args = { photo, net: new URL(NET, document.baseURI).href };
    try {
      return await pool.run({ op: 'mask', args, photo: name, priority: Priority.REST, ...call });
    } finally {
      clearTimeout(resting);
      resting = setTimeout(dispose, REST);
    }
  }

  function dispose() {
    clearTimeout(resting);
    pool?.dispose();
    pool = undefined;
  }
}

function spawn() {
  return new Worker(new URL('./subject-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-subject' });
}
