// @ts-check
/**
 * The picture of a style that is being designed, by a worker of its own, which keeps the picture after every block: it
 * computes only what a change touches. The worker starts with the first call.
 */

import { createPool } from './pool.js';
import { Priority } from './queue.js';

/**
 * `times`: milliseconds of each block by its place, 256 more in the foreground; `stages`: the pictures after them,
 * where they were asked for.
 * @typedef {import('./protocol.js').BitmapPatch & { times: [number, number][], stages: { place: number, bitmap: ImageBitmap }[] }} Designed
 */

/** What is added to the place of a block in the foreground. */
export const FOREGROUND = 256;

/** @param {ReturnType<typeof import('./photos.js').createPhotos>} photos */
export function createDesign(photos) {
  /** @type {(() => Worker) | undefined} */
  let spawn;
  /** @type {ReturnType<typeof createPool> | undefined} */
  let pool;

  return {
    /** @param {() => Worker} how a worker is made */
    prepare: (how) => {
      spawn = how;
    },
    draw,
    dispose: () => pool?.dispose(),
  };

  /**
   * @param {string} id of a photo
   * @param {import('./documents.js').Style} style
   * @param {{ width: number, height: number, stages?: number }} size `stages`: the longer side of the pictures after
   *   each block; none unless told
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<Designed>}
   */
  async function draw(id, style, { width, height, stages = 0 }, call) {
    const { name, work } = photos.get(id);
    pool ??= createPool({ size: 1, spawn: /** @type {() => Worker} */ (spawn) });
    const args = { photo: work, style: JSON.stringify(style), width, height, stages };
    return pool.run({ op: 'design', args, photo: name, holds: [work.key], priority: Priority.PANEL, ...call });
  }
}
