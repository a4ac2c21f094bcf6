// @ts-check
/** Gestures of fingers on a touch screen. */

import { expect, idle } from './support.js';

/** @typedef {import('./support.js').Page} Page */
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

/** Returns the controls that a finger of 44 pixels would miss. @param {Page} page @returns {Promise<string[]>} */
const missed = (page) =>
  page.evaluate(() => {
    const wrong = [];
    for (const element of document.querySelectorAll('button, select, summary, textarea, input, [role=slider]')) {
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      const box = element.getBoundingClientRect();
      const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
      // Controls outside of a scrolled area, and texts for screen readers.
      const hit = document.elementFromPoint(x, y);
      if (box.width < 2 || !hit || !(element.contains(hit) || hit.contains(element))) continue;
      // A label is part of its check box.
      const target = element.closest('label') ?? element;
      // A control that is cut by scrolling.
      const cut = element.closest('.sheet-body')?.getBoundingClientRect();
      const whole = target.getBoundingClientRect();
      if (cut && (whole.bottom > cut.bottom || whole.top < cut.top)) continue;
      const owns = (/** @type {number} */ dx, /** @type {number} */ dy) => {
        const [px, py] = [x + dx, y + dy];
        if (px < 0 || py < 0 || px >= innerWidth || py >= innerHeight) return true;
        const there = document.elementFromPoint(px, py);
        return there !== null && (target.contains(there) || there.contains(target));
      };
      if (![owns(-20, 0), owns(20, 0), owns(0, -20), owns(0, 20)].every(Boolean))
        wrong.push(`${element.getAttribute('aria-label') ?? element.textContent} ${box.width}x${box.height}`);
    }
    return wrong;
  });

/** Checks that no control of the board, its drawers and its panels is too small for a finger. @param {Page} page */
export async function expectTouchTargets(page) {
  // Drawers are animated.
  const check = (/** @type {string} */ place) => expect.poll(() => missed(page), place).toEqual([]);
  await check('board');
  for (const name of ['Photos', 'Styles', 'Layouts', 'Text', 'Page settings']) {
    if (name === 'Page settings') await page.getByRole('button', { name: 'Menu' }).tap();
    await page.getByRole('button', { name, exact: true }).tap();
    await idle(page);
    await check(name);
    await page.getByRole('button', { name: 'Close', exact: true }).tap();
  }
  await page.getByRole('group', { name: /^Panel 2 of/ }).tap();
  await check('panel');
}
