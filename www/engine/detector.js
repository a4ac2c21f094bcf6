// @ts-check
/**
 * Faces and objects in photos, each by a worker of its own, side by side. A worker and all it needs are loaded with
 * its first call, or before by `load`.
 */

import { createPool } from './pool.js';
import { Priority } from './queue.js';

/**
 * Something found in a photo; its place in fractions of the photo.
 * @typedef {{ label: string, score: number, x: number, y: number, width: number, height: number }} Found
 */

/** @typedef {'faces' | 'objects'} Net */

/**
 * @param {ReturnType<typeof import('./photos.js').createPhotos>} photos
 * @param {(workers: number) => void} spare asks that so many other workers stay idle meanwhile, where nobody waits
 */
export function createDetector(photos, spare) {
  /** @type {Partial<Record<Net, ReturnType<typeof createPool>>>} */
  const pools = {};
  /** Nets that are made, or in line to be. @type {Partial<Record<Net, Promise<void>>>} */
  const made = {};
  /** The end of that line. */
  let last = Promise.resolve();
  let running = 0;

  return {
    load, detect, findFaces, findMoreFaces, findObjects,
    dispose: () => Object.values(pools).forEach((pool) => pool.dispose()),
  };

  /** Fetches what the nets need, which takes no core from whoever works; what fails is told by the first look. */
  function load() {
    for (const net of /** @type {const} */ (['objects', 'faces'])) {
      if (!pools[net]) order(net, 'load').catch(() => {});
    }
  }

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
    const [objects, all] = await Promise.all([findObjects(id, call), faces()]);
    return [...all, ...objects];
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
   * @param {Net} net
   * @param {import('./detector-worker.js').Look} op
   * @param {string} id
   * @param {{ boxes?: Found[] }} more
   * @param {import('./engine.js').Call} [call]
   * @returns {Promise<any>}
   */
  async function run(net, op, id, more, call) {
    const { name, work } = photos.get(id);
    spare((running += 1));
    try {
      await make(net);
      return await open(net).run({ op, args: { photo: work, ...more }, photo: name, priority: Priority.REST, ...call });
    } finally {
      spare((running -= 1));
    }
  }

  /**
   * One net after the other: the browser compiles the module's code while the first is made, and two at a time wait for
   * each other's share of the cores.
   * @param {Net} net
   */
  function make(net) {
    made[net] ??= last = last.catch(() => {}).then(() => order(net, 'make')).catch((error) => {
      delete made[net];
      throw error;
    });
    return made[net];
  }

  /**
   * @param {Net} net
   * @param {'load' | 'make'} op
   * @returns {Promise<void>}
   */
  function order(net, op) {
    return open(net).run({ op, args: { net }, priority: Priority.REST });
  }

  /** @param {Net} net */
  function open(net) {
    return (pools[net] ??= createPool({ size: 1, spawn }));
  }
}

function spawn() {
  return new Worker(new URL('./detector-worker.js', import.meta.url), { type: 'module', name: 'inkpanel-detector' });
}
