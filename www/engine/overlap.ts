/**
 * Pages at print size take 35 MB each, so only few are drawn at the same time. A page starts before the previous one is
 * complete, because a page with one photo keeps only one worker busy.
 */

/** Maximum number of pages that are drawn at the same time. */
const AT_ONCE = 2;

/**
 * Works on items in order. An item starts when fewer than two are in work. After a failure no other item starts.
 * @returns the results, in the order of the items
 */
export async function overlapped<T, R>(
  items: readonly T[],
  work: (item: T, index: number) => Promise<R>,
): Promise<R[]> {
  const results: R[] = [];
  const rest = items.entries();
  const lane = async () => {
    for (const [i, item] of rest) results[i] = await work(item, i);
  };
  await Promise.all(Array.from({ length: AT_ONCE }, lane));
  return results;
}
