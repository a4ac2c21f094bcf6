/** Locks that tabs of one browser share. Without lock support, each tab works as if it were the only one. */

type Release = () => void;
export type Locks = ReturnType<typeof createLocks>;

export function createLocks(manager: Pick<LockManager, 'request'> | undefined) {
  return { take, wait, during };

  /**
   * @param patience maximum milliseconds to wait for it
   * @returns null while another tab holds it
   */
  async function take(name: string, patience: number = 0): Promise<Release | null> {
    if (patience === 0) return hold(name, { ifAvailable: true });
    return wait(name, AbortSignal.timeout(patience)).catch(() => null);
  }

  /** @returns when it is free; rejects when aborted */
  async function wait(name: string, signal: AbortSignal): Promise<Release> {
    return hold(name, { signal }) as Promise<Release>;
  }

  function hold(name: string, options: LockOptions): Promise<Release | null> {
    if (!manager) return Promise.resolve(() => {});
    return new Promise((resolve, reject) => {
      manager
        .request(name, options, (lock) => {
          if (!lock) return resolve(null);
          return new Promise((release) => {
            resolve(() => release(undefined));
          });
        })
        .catch(reject);
    });
  }

  /**
   * Holds a lock during an operation.
   * @returns null if the lock is taken and waiting was not requested
   */
  async function during<T>(name: string, options: LockOptions, work: () => Promise<T>): Promise<T | null> {
    if (!manager) return work();
    return manager.request(name, options, async (lock) => (lock ? work() : null));
  }
}

/** @param id of a project that one tab edits */
export function projectLock(id: string) {
  return `inkpanel.project.${id}`;
}

/** Shared lock for writing photos, exclusive lock for deleting unused photos. */
export const PHOTOS_LOCK = 'inkpanel.photos';
