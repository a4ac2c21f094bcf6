/**
 * Styles that look like a picture: one worker measures the picture, all of them try styles on a photo, a few in a call, and
 * the planner leads the search. It takes the same steps whatever the number of workers.
 */

import { Priority } from './queue.ts';
import { beginSearch } from './imitation-module.ts';
import { failure } from './protocol.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Run } from './pool.ts';
import type { Style } from './types.ts';

/** Trials in a call of a worker, some tens of milliseconds: it is soon free for what is waited for, and stops as soon. */
const PARCEL = 4;

export function createImitating({ run, photos }: { run: Run; photos: ReturnType<typeof createPhotos> }) {
  return { readLook, imitate };

  /**
   * The look of a picture, to be searched for. Throws `small-picture`, `blank-picture` or `plain-photo` where it has none.
   * @param id of an imported picture
   * @param call `anyway` takes all but small ones
   */
  async function readLook(id: string, { anyway = false, ...call }: Call & { anyway?: boolean } = {}): Promise<string> {
    const [photo] = photos.handles([id], 'work');
    const job = { photo: photos.names([id]), holds: [photo.key], priority: Priority.VIEW };
    return run({ ...job, op: 'readLook', args: { photo, anyway }, ...call });
  }

  /**
   * Three to six styles that give a photo that look, the nearest first, each with a score from 0 to 1.
   * @param id of an imported photo
   * @param how `onProgress` is told how far it is, 0 to 1
   */
  async function imitate(
    look: string,
    id: string,
    { seed, onProgress, signal, ...call }: Call & { seed: number; onProgress: (done: number) => void },
  ): Promise<Style[]> {
    const [photo] = photos.handles([id], 'work');
    const search = await beginSearch(look, seed);
    const job = { photo: photos.names([id]), holds: [photo.key], priority: Priority.VIEW, signal, ...call };
    try {
      for (;;) {
        const asks = search.ask();
        if (asks.length === 0) return search.proposals();
        const parcels = Array.from({ length: Math.ceil(asks.length / PARCEL) }, (_, i) =>
          asks.slice(i * PARCEL, (i + 1) * PARCEL),
        );
        const tried = await Promise.all(
          parcels.map((some) => run({ ...job, op: 'tryLooks', args: { photo, asks: some } })),
        );
        if (signal?.aborted) throw failure('cancelled', 'cancelled');
        search.tell(tried.flat());
        onProgress(search.progress());
      }
    } finally {
      search.free();
    }
  }
}
