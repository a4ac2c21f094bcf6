// @ts-check
/**
 * Faces and objects in photos, by a worker of its own. The worker and all it needs are loaded with the first call.
 */

import { createPool } from './pool.js';
import { Priority } from './queue.js';

/**
 * Something found in a photo; its place in fractions of the photo.
 * @typedef {{ label: string, score: number, x: number, y: number, width: number, height: number }} Found
 */

/** Also for loading and preparing the nets, on a slow phone. */
const TIMEOUT = 120_000;

/**
 * @param {ReturnType<typeof import('./photos.js').createPhotos>} photos
 * @param {(workers: number) => void} spare asks that so many other workers stay idle meanwhile, where nobody waits
 */
export function createDetector(photos, spare) {
  /** @type {ReturnType<typeof createPool> | undefined} */
  let pool;
  return { look, lookCloser, dispose: () => pool?.dispose() };

  /**
   * Faces and objects; `closer` tells whether a closer look may find more faces.
   * @param {string} id of an imported photo
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<{ boxes: Found[], closer: boolean }>}
   */
  function look(id, call) {
    return run('look', id, {}, call);
  }

  /**
   * @param {string} id of an imported photo
   * @param {Found[]} boxes of the first look
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<Found[]>} what to take in their place
   */
  function lookCloser(id, boxes, call) {
    return run('lookCloser', id, { boxes }, call);
  }

  /**
   * @param {string} op
   * @param {string} id
   * @param {{ boxes?: Found[] }} more
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<any>}
   */
  async function run(op, id, more, call) {
    const { name, work } = photos.get(id);
    pool ??= createPool({ size: 1, spawn });
    spare(1);
    return pool.run({ op, args: { photo: work, ...more }, photo: name, timeout: TIMEOUT, priority: Priority.REST, ...call })
      .finally(() => spare(0));
  }
}

function spawn() {
  return new Worker(new URL('./detector-worker.js', import.meta.url), { type: 'module', name: 'inkpanel-detector' });
}
