// @ts-check
/** Text items: finding, adding and measuring them. */

import { expect, idle, pixelsOf, tab } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

export const word = (/** @type {Page} */ page, /** @type {string | RegExp} */ name) =>
  page.locator('.words').getByRole('button', { name, exact: typeof name === 'string' });

/** Opens the tab of the text items on a large screen. @param {Page} page */
export async function openWords(page) {
  const tools = page.getByRole('region', { name: 'Text', exact: true });
  await tab(page, 'Text');
  await expect(tools).toBeVisible();
}

/** @param {Page} page @param {string} kind @param {string} text */
export async function write(page, kind, text) {
  await openWords(page);
  await page.getByRole('button', { name: `Add ${kind}`, exact: true }).click();
  await expect(page.getByRole('textbox', { name: /^Text of/ })).toBeFocused();
  await page.keyboard.type(text);
  await page.keyboard.press('Enter');
  await idle(page);
}

/** Counts the pixels of the text items, and finds their middle. @param {Page} page */
export async function inked(page) {
  const address = await page
    .locator('.word-canvas')
    .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
  const { width, height, data } = pixelsOf(address);
  let [count, x, y] = [0, 0, 0];
  for (let i = 0; i < width * height; i += 1) {
    if (data[i * 4 + 3] < 128) continue;
    count += 1;
    x += i % width;
    y += Math.floor(i / width);
  }
  return { count, x: x / count / width, y: y / count / height };
}

/** The most frequent colour of the drawn text items: the fill of a balloon. @param {Page} page */
export async function drawnFill(page) {
  const address = await page
    .locator('.word-canvas')
    .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
  const { data } = pixelsOf(address);
  /** @type {Map<number, number>} */
  const counts = new Map();
  for (let i = 0; i < data.length; i += 4) {
    const colour = data.readUIntBE(i, 3);
    if (data[i + 3] === 255) counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  const [[most]] = [...counts].sort(([, a], [, b]) => b - a);
  return `rgb(${most >> 16}, ${(most >> 8) & 255}, ${most & 255})`;
}

/** @param {ReturnType<Page['locator']>} element */
export async function box(element) {
  return /** @type {{ x: number, y: number, width: number, height: number }} */ (await element.boundingBox());
}
