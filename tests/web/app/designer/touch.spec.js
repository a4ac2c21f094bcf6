// @ts-check
/** Cards and blocks of the style designer, moved by touch. */

import { addBlock, cards, names, openDesigner, preview, region } from '../style-designer.js';
import { expect, sharedBoardTest as test } from '../support.js';
import { touch, way } from '../touch.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

test.use({ viewport: { width: 1100, height: 760 }, hasTouch: true });

/** @param {ReturnType<Page['locator']>} element @returns {Promise<[number, number]>} its middle */
async function middle(element) {
  const box = await element.boundingBox();
  if (!box) throw new Error('the element is not visible');
  return [box.x + box.width / 2, box.y + box.height / 2];
}

const head = (/** @type {Page} */ page, /** @type {number} */ n) => cards(page).nth(n).locator('.card-head');
const handle = (/** @type {Page} */ page, /** @type {number} */ n) => cards(page).nth(n).locator('.card-handle');

test('a card is dragged by its handle, also to the other layer, and a swipe next to the handle scrolls', async ({
  page,
}) => {
  await openDesigner(page);
  for (const block of ['Gaussian', 'Posterization', 'Saturation', 'XDoG']) await addBlock(page, block);
  const all = ['Gaussian Smoothing', 'Posterization', 'Saturation', 'XDoG', 'Soft Threshold'];
  expect(await names(page)).toEqual(all);
  const lanes = region(page).locator('.lanes');
  await lanes.evaluate((element) => {
    element.scrollTop = 0;
  });
  const before = await preview(page);

  // One place down: past the middle of the next card.
  const next = await cards(page).nth(1).boundingBox();
  if (!next) throw new Error('the element is not visible');
  const past = next.y + 0.55 * next.height;
  await touch(page, [way(await middle(handle(page, 0)), [next.x + next.width / 2, past])]);
  await expect
    .poll(() => names(page))
    .toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation', 'XDoG', 'Soft Threshold']);
  await expect.poll(() => preview(page)).not.toBe(before);
  expect(await lanes.evaluate((element) => element.scrollTop)).toBe(0);

  // To the other layer, as one undo step.
  const lines = await middle(region(page).getByRole('list', { name: 'Foreground layer' }).locator('..').locator('h3'));
  await touch(page, [way(await middle(handle(page, 1)), [lines[0], lines[1] + 40])]);
  await expect.poll(() => names(page, 'Foreground layer')).toEqual(['Gaussian Smoothing']);
  expect(await names(page)).toEqual(['Posterization', 'Saturation', 'XDoG', 'Soft Threshold']);
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await expect.poll(() => names(page, 'Foreground layer')).toEqual([]);
  await undo.click();
  await expect.poll(() => names(page)).toEqual(all);

  // A swipe on the head of a card scrolls the lanes.
  const [x, y] = await middle(head(page, 1));
  await touch(page, [way([x, y], [x, y - 180])]);
  await expect.poll(() => lanes.evaluate((element) => element.scrollTop)).toBeGreaterThan(60);
  expect(await names(page)).toEqual(all);
});

test('a block is dragged from the palette by its handle, or after a long press', async ({ page }) => {
  await openDesigner(page);
  for (const block of ['Gaussian', 'Saturation']) await addBlock(page, block);
  // The palette is still open.
  const palette = page.getByRole('region', { name: 'Blocks to add' });
  const block = (/** @type {RegExp} */ name) => palette.getByRole('button', { name }).first();
  await touch(page, [way(await middle(block(/Posterization/).locator('.card-handle')), await middle(head(page, 0)))]);
  await expect.poll(() => names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation']);

  // A swipe scrolls the palette.
  const start = await middle(block(/Posterization/));
  await touch(page, [way(start, [start[0], start[1] - 160])]);
  await expect.poll(() => palette.getByRole('list').evaluate((list) => list.scrollTop)).toBeGreaterThan(40);
  expect(await names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation']);
  expect(await names(page, 'Foreground layer')).toEqual([]);

  // A long press starts a drag, also into the other, empty layer. No click follows.
  await block(/XDoG/).scrollIntoViewIfNeeded();
  const lines = await middle(region(page).getByRole('list', { name: 'Foreground layer' }).locator('..').locator('h3'));
  const [x, y] = await middle(block(/XDoG/));
  await touch(page, [way([x, y], [lines[0], lines[1] + 40])], () => expect(page.locator('.drag-ghost')).toBeVisible());
  await expect.poll(() => names(page, 'Foreground layer')).toEqual(['XDoG', 'Soft Threshold']);
  expect(await names(page)).toEqual(['Posterization', 'Gaussian Smoothing', 'Saturation']);
});

test('the tools of a block have their names below the icons on a phone', async ({ page }) => {
  await openDesigner(page);
  await addBlock(page, 'Gaussian');
  // On a tablet, the tools fit into their card, and the card into its lane.
  const lane = await region(page).getByRole('list', { name: 'Background layer' }).boundingBox();
  const edge = (lane?.x ?? 0) + (lane?.width ?? 0);
  for (const part of [cards(page).first(), cards(page).first().getByRole('button', { name: 'Remove' })]) {
    const box = await part.boundingBox();
    expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(edge + 1);
  }
  // The others are in a menu, which works by touch and by keys.
  const more = cards(page).first().getByRole('button', { name: 'More' });
  await more.tap();
  await cards(page).first().getByRole('button', { name: 'Duplicate' }).tap();
  await expect(cards(page)).toHaveCount(2);
  await expect(more).toBeFocused();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  expect(await names(page, 'Foreground layer')).toEqual(['Gaussian Smoothing']);
  await page.setViewportSize({ width: 390, height: 760 });
  const texts = cards(page).first().locator('.card-tools .icon-text');
  await expect(texts).toHaveText(['Skip', 'Remove', 'More', 'Up', 'Down']);
  const boxes = await texts.evaluateAll((all) => all.map((text) => text.getBoundingClientRect().toJSON()));
  boxes.slice(1).forEach(({ left, height }, i) => {
    expect(height).toBeGreaterThan(8);
    expect(left).toBeGreaterThan(boxes[i].right);
  });
});
