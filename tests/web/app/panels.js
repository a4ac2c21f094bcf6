// @ts-check
/** Actions on single panels, and comparison of the pixels of four panels. */

import { PNG, choose, expect, idle, openBoard, pixelsOf } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

export const panel = (/** @type {Page} */ page, /** @type {number} */ n) =>
  page.getByRole('group', { name: new RegExp(`^Panel ${n} of`) });

/** @param {Page} page @param {number} n @returns {Promise<{ x: number, y: number, width: number, height: number }>} */
export async function boxOf(page, n) {
  const box = await panel(page, n).boundingBox();
  if (!box) throw new Error(`no panel ${n}`);
  return box;
}

/** Four equal panels in a style of few colours. @param {Page} page */
export async function four(page) {
  await openBoard(page);
  await choose(page, 'grid', 'Four');
}

/**
 * Which of the four quarters of the page differ between two pictures.
 * @param {string} a
 * @param {string} b
 * @returns {number[]} panels, from 1
 */
export function changed(a, b) {
  const [one, two] = [pixelsOf(a), pixelsOf(b)];
  expect([one.width, one.height]).toEqual([two.width, two.height]);
  return [1, 2, 3, 4].filter((n) => differs(one, two, n));
}

/** @param {PNG} one @param {PNG} two @param {number} n */
function differs(one, two, n) {
  const [left, top] = [(((n - 1) % 2) * one.width) / 2, n > 2 ? one.height / 2 : 0];
  let different = 0;
  for (let y = Math.ceil(top); y < top + one.height / 2 - 1; y += 3) {
    for (let x = Math.ceil(left); x < left + one.width / 2 - 1; x += 3) {
      const i = (y * one.width + x) * 4;
      if (one.data.readUInt32LE(i) !== two.data.readUInt32LE(i)) different += 1;
    }
  }
  return different > 20;
}

/**
 * @param {Page} page
 * @param {[number, number]} from
 * @param {[number, number]} to
 */
export async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 3 });
  await page.mouse.move(...to, { steps: 3 });
  await page.mouse.up();
  await idle(page);
}
