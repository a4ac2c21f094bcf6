/**
 * Selects entries to evict, least recently used first, if their total size exceeds a budget.
 * @param budget bytes
 */
export function createLru(budget: number) {
  /** oldest first */
  const sizes: Map<string, number> = new Map();
  let total = 0;

  return {
    /** @returns bytes in use */
    get total(): number {
      return total;
    },

    /** Notes a use of an entry. */
    touch(key: string, bytes: number) {
      total += bytes - (sizes.get(key) ?? 0);
      sizes.delete(key);
      sizes.set(key, bytes);
    },

    forget(key: string) {
      total -= sizes.get(key) ?? 0;
      sizes.delete(key);
    },

    /**
     * Forgets the oldest entries until the rest fit.
     * @param needed entries that must not be evicted, whatever their size
     * @returns the evicted keys
     */
    evict(needed: (key: string) => boolean = () => false): string[] {
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
