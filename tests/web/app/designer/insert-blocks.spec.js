// @ts-check
/** Blocks inserted at any place of the style designer, their names, and the preview of the comic page. */

import { FOUR, addBlock, button, cards, drawn, names, openDesigner, region, startEmpty } from '../style-designer.js';
import { accessible, expect, idle, openBoard, sharedBoardTest as test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const palette = (/** @type {Page} */ page) => page.getByRole('region', { name: 'Blocks to add' });
/** @param {Page} page @param {string} term */
const block = (page, term) => palette(page).getByRole('button', { name: term }).first();
const undo = (/** @type {Page} */ page) => page.getByRole('button', { name: 'Undo', exact: true });

/** Adds three cards and opens the palette. @param {Page} page */
async function threeCards(page) {
  await openDesigner(page);
  for (const name of ['Gaussian', 'Posterization', 'Saturation']) await addBlock(page, name);
  await expect(palette(page)).toBeVisible();
}

test('a block is dragged from the palette to any place of a layer', async ({ page }) => {
  await threeCards(page);
  const head = (/** @type {number} */ n) => cards(page).nth(n).locator('.card-head');
  await block(page, 'Sobel').dragTo(head(1));
  await expect.poll(() => names(page)).toEqual(['Gaussian Smoothing', 'Sobel', 'Posterization', 'Saturation']);
  // The new card has the focus, and the palette is still there.
  await expect(cards(page).nth(1)).toBeFocused();
  await expect(palette(page)).toBeVisible();
  // A block that needs gray adds To GrayScale.
  await block(page, 'Pattern Filling').dragTo(head(0));
  await expect
    .poll(async () => (await names(page)).slice(0, 3))
    .toEqual(['To GrayScale', 'Pattern Filling', 'Gaussian Smoothing']);
  await undo(page).click();
  await undo(page).click();
  await expect.poll(() => names(page)).toEqual(['Gaussian Smoothing', 'Posterization', 'Saturation']);

  // Into the empty layer, and after the last card.
  await block(page, 'XDoG').dragTo(region(page).getByText('No blocks: no lines.'));
  await expect.poll(() => names(page, 'Foreground layer')).toEqual(['XDoG', 'Soft Threshold']);
  await block(page, 'Soft Threshold').dragTo(cards(page, 'Foreground layer').first().locator('.parameter').last());
  await expect.poll(() => names(page, 'Foreground layer')).toEqual(['XDoG', 'Soft Threshold', 'Soft Threshold']);

  // A drop outside of the layers and Escape add no block.
  await block(page, 'Hue').dragTo(page.getByRole('region', { name: 'Preview', exact: true }));
  const [from, to] = [await block(page, 'Hue').boundingBox(), await head(0).boundingBox()];
  if (!from || !to) throw new Error('not shown');
  await page.mouse.move(from.x + 30, from.y + 30);
  await page.mouse.down();
  await page.mouse.move(to.x + 30, to.y + 10, { steps: 5 });
  await expect(page.locator('.drag-ghost')).toHaveText('Shift colours (Hue)');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect(page.locator('.drag-ghost')).toHaveCount(0);
  await expect(palette(page)).toBeVisible();
  expect(await names(page)).toEqual(['Gaussian Smoothing', 'Posterization', 'Saturation']);
});

test('keyboard: a block is inserted before another', async ({ page }) => {
  await openDesigner(page);
  for (const name of ['Gaussian', 'Posterization']) await addBlock(page, name);
  await cards(page)
    .nth(1)
    .getByRole('button', { name: 'Insert a block before 2. Few colours (Posterization)' })
    .focus();
  await page.keyboard.press('Enter');
  await expect(palette(page)).toContainText('Is inserted before 2. Few colours (Posterization)');
  await accessible(page);
  await page.keyboard.type('blur');
  await page.keyboard.press('Enter');
  await expect.poll(() => names(page)).toEqual(['Gaussian Smoothing', 'Gaussian Smoothing', 'Posterization']);
  await expect(cards(page).nth(1)).toBeFocused();

  // The place applies to one block.
  await addBlock(page, 'Saturation');
  expect(await names(page)).toEqual(['Gaussian Smoothing', 'Gaussian Smoothing', 'Posterization', 'Saturation']);
  await cards(page)
    .first()
    .getByRole('button', { name: /^Insert a block before 1/ })
    .focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Add at the end instead' }).click();
  await block(page, 'Brightness').click();
  expect(await names(page)).toEqual([
    'Gaussian Smoothing',
    'Gaussian Smoothing',
    'Posterization',
    'Saturation',
    'Brightness',
  ]);
});

test('a block has a plain name and its standard term, and the search finds both', async ({ page }) => {
  await openDesigner(page);
  await addBlock(page, 'edges');
  await addBlock(page, 'sobel');
  await expect(cards(page).getByRole('heading')).toHaveText(['Edges (Sobel)', 'Edges (Sobel)']);
  await expect(cards(page).first()).toHaveAccessibleName('1. Edges (Sobel)');
});

test('the preview shows the style on the comic page', async ({ page }) => {
  await openDesigner(page);
  await addBlock(page, 'Posterization');
  await expect(button(page, 'Photo')).toHaveAttribute('aria-pressed', 'true');
  await button(page, 'Page').click();
  const seen = region(page).getByRole('img', { name: 'Preview of the page' });
  await expect(seen).toBeVisible();
  const pixels = () => seen.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
  await drawn(page);
  const first = await pixels();
  const shape = await seen.evaluate((canvas) => {
    const { width, height } = /** @type {HTMLCanvasElement} */ (canvas);
    return width / height;
  });
  // The page on the board is A4 in portrait orientation.
  expect(Math.abs(shape - 2480 / 3508)).toBeLessThan(0.01);
  await expect(button(page, 'Four photos')).toHaveCount(0);
  // A slider updates it, and the cards have their pictures.
  const levels = cards(page).first().getByRole('slider', { name: 'Levels' });
  await levels.fill('3');
  await expect.poll(pixels).not.toBe(first);
  await button(page, 'Compare with original').click();
  await expect(page.getByRole('slider', { name: 'Before and after' })).toBeVisible();
  await drawn(page);
  await accessible(page);
  await button(page, 'Photo').click();
  await expect(seen).toHaveCount(0);
  await drawn(page);
});

test('a block is inserted before another in a small window', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByRole('button', { name: 'Menu', exact: true }).click();
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  await startEmpty(page);
  for (const name of ['Gaussian', 'Posterization']) await addBlock(page, name);
  await cards(page)
    .nth(1)
    .getByRole('button', { name: /^Insert a block before/ })
    .click();
  await expect(palette(page)).toBeVisible();
  await block(page, 'Saturation').click();
  await expect(palette(page)).toHaveCount(0);
  expect(await names(page)).toEqual(['Gaussian Smoothing', 'Saturation', 'Posterization']);
  await idle(page);
});
