// @ts-check
/**
 * Which entries to give up, least recently used first, once their sizes exceed a budget.
 * @param {number} budget bytes
 */
export function createLru(budget) {
  /** @type {Map<string, number>} oldest first */
  const sizes = new Map();
  let total = 0;

  return {
    /** @returns {number} bytes in use */
    get total() {
      return total;
    },

    /**
     * Notes a use of an entry.
     * @param {string} key
     * @param {number} bytes
     */
    touch(key, bytes) {
      total += bytes - (sizes.get(key) ?? 0);
      sizes.delete(key);
      sizes.set(key, bytes);
    },

    /** @param {string} key */
    forget(key) {
      total -= sizes.get(key) ?? 0;
      sizes.delete(key);
    },

    /**
     * Forgets the oldest entries until the rest fit.
     * @param {(key: string) => boolean} [needed] entries that must stay, whatever they weigh
     * @returns {string[]} what was forgotten
     */
    evict(needed = () => false) {
      const gone = [];
      for (const [key, bytes] of sizes) {
        if (total <= budget) break;
        if (needed(key)) continue;
        sizes.delete(key);
        total -= bytes;
        gone.push(key);
      }
      return gone;
    },
  };
}
