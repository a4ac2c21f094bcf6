// @ts-check
/**
 * The order of waiting work: lower priority numbers first, then first come, first served. At most one waiting
 * entry a key: a newer one takes the older one's place.
 */

/**
 * What the person looks at comes first.
 * @readonly
 * @enum {number}
 */
export const Priority = {
  /** A panel of the visible page. */
  PANEL: 0,
  /** A photo that the visible page waits for, and the file that a person asked to download. */
  PAGE: 1,
  /** A thumbnail in view. */
  VIEW: 2,
  /** Everything else. */
  REST: 3,
};

/** Waiting entries from which on the page shall stay quick rather than all be done soon. */
export const CROWD = 24;

/**
 * @template {{ priority: number, key?: string }} T
 */
export function createQueue() {
  /** @type {T[]} */
  const waiting = [];

  return {
    /** @returns {number} */
    get length() {
      return waiting.length;
    },

    /** @returns {number} the priority of what comes next */
    get urgency() {
      return waiting[0]?.priority ?? Infinity;
    },

    /** @returns {boolean} whether there is nothing else but much that nobody waits for: with it on all cores, the page would wait for one */
    get crowded() {
      return waiting.length > CROWD && waiting[0].priority >= Priority.REST;
    },

    /**
     * @param {T} entry
     * @returns {T | undefined} the older entry of the same key that was dropped for this one
     */
    push(entry) {
      const older = entry.key === undefined ? -1 : waiting.findIndex((other) => other.key === entry.key);
      const dropped = older < 0 ? undefined : waiting.splice(older, 1)[0];
      let at = waiting.length;
      while (at > 0 && waiting[at - 1].priority > entry.priority) at -= 1;
      waiting.splice(at, 0, entry);
      return dropped;
    },

    /**
     * Takes the first entry, or, among those of the same priority, the one that suits best.
     * @param {(entry: T) => number} [suits] higher is better; the earlier of equals is taken
     * @returns {T | undefined}
     */
    take(suits) {
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

    /**
     * @param {T} entry
     * @returns {boolean} whether it was waiting
     */
    remove(entry) {
      const at = waiting.indexOf(entry);
      if (at >= 0) waiting.splice(at, 1);
      return at >= 0;
    },

    /** @returns {T[]} everything that was waiting */
    clear() {
      return waiting.splice(0);
    },
  };
}
