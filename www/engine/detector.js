// @ts-check
/**
 * Faces and objects in photos, each by a worker of its own, side by side. A worker and all it needs are loaded with
 * its first call.
 */

import { createPool } from './pool.js';
import { Priority } from './queue.js';

/**
 * Something found in a photo; its place in fractions of the photo.
 * @typedef {{ label: string, score: number, x: number, y: number, width: number, height: number }} Found
 */

/** Also for loading and preparing a net, on a slow phone. */
const TIMEOUT = 120_000;

/**
 * @param {ReturnType<typeof import('./photos.js').createPhotos>} photos
 * @param {(workers: number) => void} spare asks that so many other workers stay idle meanwhile, where nobody waits
 */
export function createDetector(photos, spare) {
  /** @type {{ faces?: ReturnType<typeof createPool>, objects?: ReturnType<typeof createPool> }} */
  const pools = {};
  let running = 0;

  return {
    detect, findFaces, findMoreFaces, findObjects,
    dispose: () => Object.values(pools).forEach((pool) => pool.dispose()),
  };

  /**
   * Everything that is found in a photo, faces first.
   * @param {string} id of an imported photo
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<Found[]>}
   */
  async function detect(id, call) {
    const faces = async () => {
      const { boxes, closer } = await findFaces(id, call);
      return closer ? findMoreFaces(id, boxes, call) : boxes;
    };
    return (await Promise.all([faces(), findObjects(id, call)])).flat();
  }

  /**
   * `closer` tells whether `findMoreFaces` may find more.
   * @param {string} id of an imported photo
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<{ boxes: Found[], closer: boolean }>}
   */
  function findFaces(id, call) {
    return run('faces', 'faces', id, {}, call);
  }

  /**
   * Also the small faces, by looking at parts of the photo.
   * @param {string} id of an imported photo
   * @param {Found[]} boxes the faces found at first
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<Found[]>} what to take in their place
   */
  function findMoreFaces(id, boxes, call) {
    return run('faces', 'closer', id, { boxes }, call);
  }

  /**
   * @param {string} id of an imported photo
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<Found[]>}
   */
  function findObjects(id, call) {
    return run('objects', 'objects', id, {}, call);
  }

  /**
   * @param {'faces' | 'objects'} net
   * @param {import('./detector-worker.js').Op} op
   * @param {string} id
   * @param {{ boxes?: Found[] }} more
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<any>}
   */
  async function run(net, op, id, more, call) {
    const { name, work } = photos.get(id);
    const pool = (pools[net] ??= createPool({ size: 1, spawn }));
    spare((running += 1));
    return pool.run({ op, args: { photo: work, ...more }, photo: name, timeout: TIMEOUT, priority: Priority.REST, ...call })
      .finally(() => spare((running -= 1)));
  }
}

function spawn() {
  return new Worker(new URL('./detector-worker.js', import.meta.url), { type: 'module', name: 'inkpanel-detector' });
}
