// @ts-check
/** The whole photo around its panel while it is cropped, the photo under the pointer, and the page without a style. */

import { boxOf, changed, four, panel } from '../panels.js';
import { accessible, expect, idle, picture, press, testsOn } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const test = testsOn(four);

/** @param {Page} page */
const ghost = (page) => page.locator('.crop-ghost');
/** @param {Page} page */
const carried = (page) => page.locator('.carried-photo');

test('cropping shows the whole photo around its panel, and leaves the panel free', async ({ page }) => {
  await expect(ghost(page)).toHaveCount(0);
  await panel(page, 2).click();
  // Two colours, so that the selection is visible on a page of one of them.
  await expect(page.locator('.panel-choice .panel-casing > *')).toHaveCount(1);
  await press(page, 'Crop');
  await expect(ghost(page).locator('[data-drawn=true]')).toBeVisible();
  const box = await boxOf(page, 2);
  const whole = await ghost(page).evaluate((element) => element.getBoundingClientRect().toJSON());
  // The crop is a part of the photo.
  expect(whole.x).toBeLessThanOrEqual(box.x + 1);
  expect(whole.y).toBeLessThanOrEqual(box.y + 1);
  expect(whole.x + whole.width).toBeGreaterThanOrEqual(box.x + box.width - 1);
  expect(whole.y + whole.height).toBeGreaterThanOrEqual(box.y + box.height - 1);
  expect(whole.width * whole.height).toBeGreaterThan(1.05 * box.width * box.height);
  // The photo keeps its proportions.
  const aspect = await ghost(page)
    .locator('canvas')
    .evaluate((canvas) => {
      const { width, height } = /** @type {HTMLCanvasElement} */ (canvas);
      return width / height;
    });
  expect(whole.width / whole.height).toBeCloseTo(aspect, 1);
  await accessible(page);
  await press(page, 'Zoom in');
  await expect.poll(() => ghost(page).evaluate((element) => element.clientWidth)).toBeGreaterThan(1.1 * whole.width);
  await press(page, 'Done');
  await expect(ghost(page)).toHaveCount(0);
});

test('the photo around its panel leaves the other panels visible', async ({ page }) => {
  const { x, y, width, height } = await boxOf(page, 1);
  const clip = { x: x + 4, y: y + 4, width: width / 2, height: height - 8 };
  await panel(page, 2).click();
  const before = await page.screenshot({ clip });
  await press(page, 'Crop');
  await expect(ghost(page).locator('[data-drawn=true]')).toBeVisible();
  const left = () => ghost(page).evaluate((element) => element.getBoundingClientRect().left);
  while ((await left()) > clip.x) {
    await press(page, 'Zoom in');
    await idle(page);
  }
  expect((await page.screenshot({ clip })).equals(before)).toBe(true);
  await press(page, 'Done');
});

test('the whole photo follows a drag, and the arrow keys', async ({ page }) => {
  const { x, y, width, height } = await boxOf(page, 1);
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 12, y + height / 2 + 12, { steps: 4 });
  await expect(ghost(page)).toHaveCount(1);
  await page.mouse.up();
  await idle(page);
  await expect(ghost(page)).toHaveCount(0);
  await panel(page, 1).focus();
  await page.keyboard.press('Enter');
  await expect(ghost(page)).toHaveCount(1);
  await page.keyboard.press('Escape');
  await expect(ghost(page)).toHaveCount(0);
});

test('a photo that is dragged to another panel is under the pointer', async ({ page }) => {
  const [from, to] = [await boxOf(page, 1), await boxOf(page, 2)];
  await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2);
  await page.mouse.down();
  const [x, y] = [to.x + to.width / 2, to.y + to.height / 2];
  await page.mouse.move(x, y, { steps: 6 });
  await expect(carried(page).locator('[data-drawn=true]')).toBeVisible();
  await expect(ghost(page)).toHaveCount(0);
  const box = await carried(page).evaluate((element) => element.getBoundingClientRect().toJSON());
  expect(x).toBeGreaterThan(box.left);
  expect(x).toBeLessThan(box.right);
  expect(y).toBeGreaterThan(box.top);
  expect(y).toBeLessThan(box.bottom);
  const photo = (/** @type {number} */ n) => panel(page, n).getAttribute('aria-description');
  const before = await photo(1);
  await page.mouse.up();
  await idle(page);
  await expect(carried(page)).toHaveCount(0);
  expect((await photo(2))?.split(',')[0]).toBe(before?.split(',')[0]);
});

test('O shows the photos without a style as long as it is held, and a tool until it is pressed again', async ({
  page,
}) => {
  const originals = page.locator('.originals [data-drawn=true]');
  const before = await picture(page);
  await page.keyboard.down('o');
  await expect(originals).toBeVisible();
  await page.keyboard.up('o');
  await expect(originals).toHaveCount(0);
  await press(page, 'Show original photos');
  await expect(originals).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(originals).toHaveCount(0);
  expect(await picture(page)).toBe(before);
});

/** @param {Page} page @returns {Promise<number>} width over height of the photo that is being cropped */
const aspectOf = (page) => ghost(page).evaluate((element) => element.clientWidth / element.clientHeight);

test('a photo is rotated and flipped while it is cropped, and each is one step', async ({ page }) => {
  await panel(page, 2).click();
  const photo = await panel(page, 2).getAttribute('aria-description');
  await press(page, 'Crop');
  const aspect = await aspectOf(page);
  const before = await picture(page);
  await press(page, 'Rotate photo');
  await expect.poll(() => aspectOf(page)).toBeCloseTo(1 / aspect, 1);
  expect(changed(before, await picture(page))).toEqual([2]);
  expect((await panel(page, 2).getAttribute('aria-description'))?.split(',')[0]).toBe(photo?.split(',')[0]);
  const rotated = await picture(page);
  await press(page, 'Flip photo');
  await expect.poll(() => aspectOf(page)).toBeCloseTo(1 / aspect, 1);
  expect(changed(rotated, await picture(page))).toEqual([2]);
  await accessible(page);
  await press(page, 'Done');
  await press(page, 'Undo');
  expect(await picture(page)).toBe(rotated);
  await press(page, 'Undo');
  expect(await picture(page)).toBe(before);
});
