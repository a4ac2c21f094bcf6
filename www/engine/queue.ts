/**
 * The queue of jobs: lower priority numbers first, then in order of arrival. At most one entry per key is waiting: a
 * newer one replaces the older one.
 */

/** Priorities of jobs. Visible content comes first. */
export const Priority = {
  /** A panel of the visible page. */
  PANEL: 0,
  /** A photo for the visible page, or a file that the user exports. */
  PAGE: 1,
  /** A thumbnail in view. */
  VIEW: 2,
  /** Everything else. */
  REST: 3,
} as const;

/** One of them. */
export type Priority = (typeof Priority)[keyof typeof Priority];

/** Minimum number of waiting entries at which quick response is more important than throughput. */
export const CROWD = 24;

export function createQueue<T extends { priority: number; key?: string }>() {
  const waiting: T[] = [];

  return {
    get length(): number {
      return waiting.length;
    },

    /** @returns priority of the next entry */
    get urgency(): number {
      return waiting[0]?.priority ?? Infinity;
    },

    /**
     * @returns `true` if the queue holds only low-priority jobs, more than `CROWD` of them. Running them on all cores
     *   would delay the next urgent job
     */
    get crowded(): boolean {
      return waiting.length > CROWD && waiting[0].priority >= Priority.REST;
    },

    /** @returns the older entry of the same key that was dropped for this one */
    push(entry: T): T | undefined {
      const older = entry.key === undefined ? -1 : waiting.findIndex((other) => other.key === entry.key);
      const dropped = older < 0 ? undefined : waiting.splice(older, 1)[0];
      let at = waiting.length;
      while (at > 0 && waiting[at - 1].priority > entry.priority) at -= 1;
      waiting.splice(at, 0, entry);
      return dropped;
    },

    /**
     * Takes the first entry, or the most suitable entry of the same priority.
     * @param suits higher is better; the earlier of equals is taken
     */
    take(suits?: (entry: T) => number): T | undefined {
      if (waiting.length === 0) return undefined;
      let best = 0;
      if (suits) {
        let mark = suits(waiting[0]);
        for (let i = 1; i < waiting.length && waiting[i].priority === waiting[0].priority; i += 1) {
          const other = suits(waiting[i]);
          if (other > mark) {
            best = i;
            mark = other;
          }
        }
      }
      return waiting.splice(best, 1)[0];
    },

    /** @returns whether it was waiting */
    remove(entry: T): boolean {
      const at = waiting.indexOf(entry);
      if (at >= 0) waiting.splice(at, 1);
      return at >= 0;
    },

    /** @returns everything that was waiting */
    clear(): T[] {
      return waiting.splice(0);
    },
  };
}
