// @ts-check
/**
 * How good a photo looks in a style, by a net: the style is drawn by the core, the picture is scored by a worker of its
 * own. That, and all it needs, is loaded with the first call. The net is optional when the site is built.
 */

import { NET } from './aesthetics-net.js';
import { createPool } from './pool.js';
import { failure } from './protocol.js';
import { Priority } from './queue.js';

/**
 * @param {{ run: (job: import('./pool.js').Job) => Promise<any>, photos: ReturnType<typeof import('./photos.js').createPhotos> }} engine
 */
export function createAesthetics({ run, photos }) {
  /** @type {ReturnType<typeof createPool> | undefined} */
  let pool;
  return { judges: NET !== undefined, judgeStyle, dispose: () => pool?.dispose() };

  /**
   * The mean score from 1 to 10 that people would give a photo in a style.
   * @param {string} id of an imported photo
   * @param {object} style
   * @param {{ width: number, height: number }} size at which it is drawn
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<number>}
   */
  async function judgeStyle(id, style, { width, height }, call) {
    if (!NET) throw failure('net-missing', 'The net that scores pictures is not part of this site.');
    const [photo] = photos.handles([id], 'small');
    const job = { photo: photos.names([id]), priority: Priority.REST, ...call };
    const args = { photo, style: JSON.stringify(style), width, height };
    /** @type {import('./protocol.js').PixelPatch} */
    const picture = await run({ ...job, op: 'stylePixels', args, holds: [photo.key] });
    pool ??= createPool({ size: 1, spawn });
    const { data } = picture;
    return pool.run({ ...job, op: 'judge', args: { width, height, data, net: new URL(NET, document.baseURI).href }, transfer: [data.buffer] });
  }
}

function spawn() {
  return new Worker(new URL('./aesthetics-worker.js', import.meta.url), { type: 'module', name: 'inkpanel-aesthetics' });
}
