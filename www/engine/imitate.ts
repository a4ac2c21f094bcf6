/**
 * Styles that look like a picture: one worker measures the picture, all workers try styles on a photo in batches, and
 * the planner controls the search. The steps do not depend on the number of workers.
 *
 * Every search begins with the same survey of a photo in the built-in styles. The survey does not depend on the
 * picture, so it runs while the user chooses one, and is cached for the next search.
 */

import { Priority } from './queue.ts';
import { beginSearch, surveyed } from './imitation-module.ts';
import { failure } from './protocol.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Run } from './pool.ts';
import type { PhotoHandle, Trial } from './protocol.ts';
import type { Style } from './types.ts';

/**
 * Trials per call of a worker, some tens of milliseconds. Workers are soon free for urgent jobs, and cancellation is
 * fast.
 */
const PARCEL = 2;
/** Maximum number of waiting calls of a survey. Urgent jobs overtake them. */
const WAITING = 8;

type Tried = (string | null)[];
/** Receives the number of finished trials of a request. */
type OnTried = (count: number) => void;
type Survey = {
  /** Key of the photo. */
  key: string;
  asks: string;
  tried: Promise<Tried>;
  /** Raises the priority of all waiting calls, and reports their progress. */
  hurry: (onTried: OnTried) => void;
};

export function createImitating({ run, photos }: { run: Run; photos: ReturnType<typeof createPhotos> }) {
  let known: Survey | null = null;

  return { readLook, surveyLooks, imitate };

  /**
   * Measures the look of a picture for a search. Throws `small-picture`, `blank-picture` or `plain-photo` if the
   * picture has no style.
   * @param id of an imported picture
   * @param call `anyway` accepts all pictures that are large enough
   */
  async function readLook(id: string, { anyway = false, ...call }: Call & { anyway?: boolean } = {}): Promise<string> {
    const [photo] = photos.handles([id], 'work');
    const job = { photo: photos.names([id]), holds: [photo.key], priority: Priority.VIEW };
    return run({ ...job, op: 'readLook', args: { photo, anyway }, ...call });
  }

  /**
   * Runs the survey of a photo in idle time. Resolves when it is done.
   * @param id of an imported photo
   */
  async function surveyLooks(id: string, { signal }: Call = {}): Promise<void> {
    const asks = await surveyed();
    if (signal?.aborted) throw failure('cancelled', 'cancelled');
    const [photo] = photos.handles([id], 'work');
    if (known?.key !== photo.key) {
      const begun = survey(photo, id, asks, signal);
      known = begun;
      begun.tried.catch(() => {
        if (known === begun) known = null;
      });
    }
    await known.tried;
  }

  function survey(photo: PhotoHandle, id: string, asks: Trial[], signal?: AbortSignal): Survey {
    let priority: Priority = Priority.REST;
    let onTried: OnTried | undefined;
    const parcels = inParcels(asks);
    const found: Tried[] = [];
    let [next, count] = [0, 0];
    const work = async () => {
      while (next < parcels.length) {
        const at = next;
        next += 1;
        found[at] = await attempt(photo, id, parcels[at], { signal, priority });
        count += parcels[at].length;
        onTried?.(count);
      }
    };
    return {
      key: photo.key,
      asks: JSON.stringify(asks),
      tried: Promise.all(Array.from({ length: WAITING }, work)).then(() => found.flat()),
      hurry: (tell) => {
        priority = Priority.VIEW;
        onTried = tell;
      },
    };
  }

  /** Results of a survey with the same requests for the photo; undefined if the survey is missing or failed. */
  async function fromSurvey(photo: PhotoHandle, asks: Trial[], onTried: OnTried): Promise<Tried | undefined> {
    if (known?.key !== photo.key || known.asks !== JSON.stringify(asks)) return undefined;
    known.hurry(onTried);
    try {
      return await known.tried;
    } catch {
      return undefined;
    }
  }

  async function attemptAll(
    photo: PhotoHandle,
    id: string,
    asks: Trial[],
    onTried: OnTried,
    call: Call,
  ): Promise<Tried> {
    let count = 0;
    const parcels = inParcels(asks).map(async (some) => {
      const tried = await attempt(photo, id, some, call);
      count += some.length;
      onTried(count);
      return tried;
    });
    return (await Promise.all(parcels)).flat();
  }

  function attempt(photo: PhotoHandle, id: string, asks: Trial[], call: Call): Promise<Tried> {
    const job = { photo: photos.names([id]), holds: [photo.key], priority: Priority.VIEW };
    return run({ ...job, op: 'tryLooks', args: { photo, asks }, ...call });
  }

  /**
   * Finds three to six styles that give a photo that look, the closest first, each with a score from 0 to 1.
   * @param id of an imported photo
   * @param how `onProgress` gets the progress, 0 to 1
   */
  async function imitate(
    look: string,
    id: string,
    { seed, onProgress, signal, ...call }: Call & { seed: number; onProgress: (done: number) => void },
  ): Promise<Style[]> {
    const [photo] = photos.handles([id], 'work');
    const search = await beginSearch(look, seed);
    let ended = false;
    try {
      for (let asks = search.ask(); asks.length > 0; asks = search.ask()) {
        const onTried = (count: number) => {
          if (!ended) onProgress(search.progress(count));
        };
        const tried =
          (await fromSurvey(photo, asks, onTried)) ?? (await attemptAll(photo, id, asks, onTried, { signal, ...call }));
        if (signal?.aborted) throw failure('cancelled', 'cancelled');
        search.tell(tried);
      }
      return search.proposals();
    } finally {
      // A survey continues after a stopped search.
      ended = true;
      search.free();
    }
  }
}

function inParcels(asks: Trial[]): Trial[][] {
  return Array.from({ length: Math.ceil(asks.length / PARCEL) }, (_, i) => asks.slice(i * PARCEL, (i + 1) * PARCEL));
}
