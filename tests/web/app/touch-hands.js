// @ts-check
/** Gestures of fingers on a touch screen. */

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {[number, number]} Point */

/**
 * @param {Page} page
 * @param {Point[][]} fingers the path of each finger
 * @param {() => Promise<void>} [held] runs before the fingers move and after they touch the screen
 */
export async function touch(page, fingers, held = async () => {}) {
  const client = await page.context().newCDPSession(page);
  const points = (/** @type {number} */ at) => fingers.map((path, id) => ({ x: path[at][0], y: path[at][1], id }));
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
  await held();
  for (let i = 1; i < fingers[0].length; i += 1)
    await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(i) });
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await client.detach();
}

/** A path of small steps. @param {Point} from @param {Point} to @param {number} [steps] @returns {Point[]} */
export function way(from, to, steps = 8) {
  return Array.from({ length: steps + 1 }, (_, i) => [
    from[0] + ((to[0] - from[0]) * i) / steps,
    from[1] + ((to[1] - from[1]) * i) / steps,
  ]);
}
