// @ts-check
/** Locks that tabs of one browser share. Where it has none, each tab goes on as if it were alone. */

/** @typedef {() => void} Release */
/** @typedef {ReturnType<typeof createLocks>} Locks */

/** @param {Pick<LockManager, 'request'> | undefined} manager */
export function createLocks(manager) {
  return { take, wait, during };

  /**
   * @param {string} name
   * @param {number} patience how long to wait for it, in ms
   * @returns {Promise<Release | null>} null while another tab holds it
   */
  async function take(name, patience = 0) {
    if (patience === 0) return hold(name, { ifAvailable: true });
    return wait(name, AbortSignal.timeout(patience)).catch(() => null);
  }

  /**
   * @param {string} name
   * @param {AbortSignal} signal
   * @returns {Promise<Release>} when it is free; rejects when aborted
   */
  async function wait(name, signal) {
    return /** @type {Promise<Release>} */ (hold(name, { signal }));
  }

  /**
   * @param {string} name
   * @param {LockOptions} options
   * @returns {Promise<Release | null>}
   */
  function hold(name, options) {
    if (!manager) return Promise.resolve(() => {});
    return new Promise((resolve, reject) => {
      manager.request(name, options, (lock) => {
        if (!lock) return resolve(null);
        return new Promise((release) => { resolve(() => release(undefined)); });
      }).catch(reject);
    });
  }

  /**
   * Holds a lock for as long as a piece of work takes.
   * @template T
   * @param {string} name
   * @param {LockOptions} options
   * @param {() => Promise<T>} work
   * @returns {Promise<T | null>} null where the lock is taken and was not to be waited for
   */
  async function during(name, options, work) {
    if (!manager) return work();
    return manager.request(name, options, async (lock) => (lock ? work() : null));
  }
}

/** @param {string} id of a project that one tab edits */
export function projectLock(id) {
  return `inkpanel.project.${id}`;
}

/** Held by all who write photos, and alone by whoever throws away those that nobody needs. */
export const PHOTOS_LOCK = 'inkpanel.photos';
