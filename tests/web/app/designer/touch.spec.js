// @ts-check
import { addBlock, cards, names, openDesigner, preview, region } from '../designer-hands.js';
import { expect, test } from '../support.js';
import { touch, way } from '../touch-hands.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

test.use({ viewport: { width: 1100, height: 760 }, hasTouch: true });

/** @param {ReturnType<Page['locator']>} element @returns {Promise<[number, number]>} its middle */
async function middle(element) {
  const box = await element.boundingBox();
  if (!box) throw new Error('it is not shown');
  return [box.x + box.width / 2, box.y + box.height / 2];
}

const head = (/** @type {Page} */ page, /** @type {number} */ n) => cards(page).nth(n).locator('.card-head');
const handle = (/** @type {Page} */ page, /** @type {number} */ n) => cards(page).nth(n).locator('.card-handle');

test('a card is carried by its handle, also to the other layer, and a finger elsewhere scrolls', async ({ page }) => {
  await openDesigner(page);
  for (const block of ['Gaussian', 'Posterization', 'Saturation', 'XDoG']) await addBlock(page, block);
  const all = ['Gaussian Smoothing', 'Posterization', 'Saturation', 'XDoG'];
  expect(await names(page)).toEqual(all);
  const lanes = region(page).locator('.lanes');
  await lanes.evaluate((element) => {
    element.scrollTop = 0;
  });
  const before = await preview(page);

  // Down by one: past the middle of the next.
  const next = await cards(page).nth(1).boundingBox();
  if (!next) throw new Error('it is not shown');
  const past = next.y + 0.55 * next.height;
  await touch(page, [way(await middle(handle(page, 0)), [next.x + next.width / 2, past])]);
  await expect.poll(() => names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation', 'XDoG']);
  expect(await preview(page)).not.toBe(before);
  expect(await lanes.evaluate((element) => element.scrollTop)).toBe(0);

  // To the other layer, and one step takes it back.
  const lines = await middle(region(page).getByRole('list', { name: 'Foreground layer' }).locator('..').locator('h3'));
  await touch(page, [way(await middle(handle(page, 1)), [lines[0], lines[1] + 40])]);
  await expect.poll(() => names(page, 'Foreground layer')).toEqual(['Gaussian Smoothing']);
  expect(await names(page)).toEqual(['Posterization', 'Saturation', 'XDoG']);
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await expect.poll(() => names(page, 'Foreground layer')).toEqual([]);
  await undo.click();
  await expect.poll(() => names(page)).toEqual(all);

  // A finger on a card's head moves the lanes and no card.
  const [x, y] = await middle(head(page, 1));
  await touch(page, [way([x, y], [x, y - 180])]);
  await expect.poll(() => lanes.evaluate((element) => element.scrollTop)).toBeGreaterThan(60);
  expect(await names(page)).toEqual(all);
});

test('a block is carried from the palette by its handle, or once a finger has stayed on it', async ({ page }) => {
  await openDesigner(page);
  for (const block of ['Gaussian', 'Saturation']) await addBlock(page, block);
  await page.getByRole('button', { name: 'Add block' }).click();
  const palette = page.getByRole('region', { name: 'Blocks to add' });
  const block = (/** @type {RegExp} */ name) => palette.getByRole('button', { name }).first();
  await touch(page, [way(await middle(block(/Posterization/).locator('.card-handle')), await middle(head(page, 0)))]);
  await expect.poll(() => names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation']);

  // A finger that goes on at once scrolls the blocks.
  const start = await middle(block(/Posterization/));
  await touch(page, [way(start, [start[0], start[1] - 160])]);
  await expect.poll(() => palette.getByRole('list').evaluate((list) => list.scrollTop)).toBeGreaterThan(40);
  expect(await names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation']);
  expect(await names(page, 'Foreground layer')).toEqual([]);

  // One that stays lifts the block, also into the other layer, which is empty; no click follows.
  await block(/XDoG/).scrollIntoViewIfNeeded();
  const lines = await middle(region(page).getByRole('list', { name: 'Foreground layer' }).locator('..').locator('h3'));
  const [x, y] = await middle(block(/XDoG/));
  const client = await page.context().newCDPSession(page);
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
  await expect(page.locator('.drag-ghost')).toBeVisible();
  for (const [px, py] of way([x, y], [lines[0], lines[1] + 40]))
    await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x: px, y: py }] });
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await expect.poll(() => names(page, 'Foreground layer')).toEqual(['XDoG']);
  expect(await names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation']);
});
