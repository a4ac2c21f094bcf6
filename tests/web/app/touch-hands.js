// @ts-check
/** Fingers on the glass. */

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {[number, number]} Point */

/**
 * @param {Page} page
 * @param {Point[][]} fingers where each goes, point by point
 */
export async function touch(page, fingers) {
  const client = await page.context().newCDPSession(page);
  const points = (/** @type {number} */ at) => fingers.map((way, id) => ({ x: way[at][0], y: way[at][1], id }));
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
  for (let i = 1; i < fingers[0].length; i += 1)
    await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(i) });
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

/** A way of small steps. @param {Point} from @param {Point} to @param {number} [steps] @returns {Point[]} */
export function way(from, to, steps = 8) {
  return Array.from({ length: steps + 1 }, (_, i) => [
    from[0] + ((to[0] - from[0]) * i) / steps,
    from[1] + ((to[1] - from[1]) * i) / steps,
  ]);
}
