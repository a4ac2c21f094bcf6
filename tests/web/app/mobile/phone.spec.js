// @ts-check
/** A phone in portrait orientation: fit of the page, drawers, swipes, and photos in their panels by touch. */

import { boxOf, panel } from '../panels.js';
import {
  choose,
  expect,
  idle,
  openBoard,
  openNewBoard,
  openStart,
  picture,
  press,
  reach,
  sharedBoardTest as test,
} from '../support.js';
import { touch, way } from '../touch.js';

/** @typedef {import('../support.js').Page} Page */
/** @typedef {import('../touch.js').Point} Point */

test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, deviceScaleFactor: 2 });

/** @param {Page} page */
const overflow = (page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

/** @param {Page} page */
const photos = (page) =>
  page
    .getByRole('group', { name: /^Panel \d/ })
    .evaluateAll((list) => list.map((element) => element.getAttribute('aria-description')?.split(',')[0]));

/** @param {Page} page */
async function openFour(page) {
  await openBoard(page);
  await page.getByRole('button', { name: 'Layouts', exact: true }).click();
  await choose(page, 'grid', 'Four');
  await page.getByRole('button', { name: 'Close' }).click();
}

/** @param {Page} page @param {number} n @returns {Promise<Point>} the middle of a panel */
async function middle(page, n) {
  const box = await boxOf(page, n);
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** Swipes over the page. @param {Page} page @param {number} by pixels to the right */
async function swipe(page, by) {
  const box = await page.locator('.page-canvas').boundingBox();
  if (!box) throw new Error('no page');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await touch(page, [way([x - by / 2, y], [x + by / 2, y], 5)]);
  await idle(page);
}

test('the start screen and the board fit into the width of a phone', async ({ page }) => {
  await openStart(page);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  await openBoard(page);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  const box = await page.locator('.page-canvas').boundingBox();
  expect(box?.width).toBeGreaterThan(280);
  for (const button of await page.getByRole('button').all()) {
    const { x, width } = (await button.boundingBox()) ?? { x: 0, width: 0 };
    const inStrip = await button.evaluate((element) => element.closest('.strip') !== null);
    if (!inStrip) expect([x >= 0, x + width <= 360]).toEqual([true, true]);
  }
});

test('Shuffle and the lists of styles and layouts change the page, which remains visible', async ({ page }) => {
  await openBoard(page);
  const before = await picture(page);
  await press(page, 'Shuffle');
  expect(await picture(page)).not.toBe(before);
  for (const list of ['Styles', 'Layouts']) {
    await page.getByRole('button', { name: list, exact: true }).click();
    const box = page.getByRole('listbox', { name: list });
    await expect(box).toBeVisible();
    await idle(page);
    const old = await picture(page);
    await box.getByRole('option', { selected: false }).first().click();
    await idle(page);
    expect(await picture(page)).not.toBe(old);
    const canvas = await page.locator('.page-canvas').boundingBox();
    expect(canvas?.height).toBeGreaterThan(150);
    await page.getByRole('button', { name: 'Close' }).click();
  }
});

test('a swipe shows another page, and a swipe back the previous one', async ({ page }) => {
  await openNewBoard(page);
  const first = await picture(page);
  await swipe(page, -200);
  const second = await picture(page);
  expect(second).not.toBe(first);
  // The number says that it is not the number of a page.
  const number = page.getByRole('button', { name: 'Page history, 2/2' });
  await expect(number.getByText('Version', { exact: true })).toBeVisible();
  await swipe(page, 200);
  expect(await picture(page)).toBe(first);
  await swipe(page, -200);
  expect(await picture(page)).toBe(second);
});

test('two fingers zoom a photo, and one finger pans it after a tap', async ({ page }) => {
  await openFour(page);
  const start = await picture(page);
  const [x, y] = await middle(page, 1);
  await touch(page, [way([x - 15, y], [x - 60, y], 3), way([x + 15, y], [x + 60, y], 3)]);
  await idle(page);
  const near = await picture(page);
  expect(near).not.toBe(start);
  await panel(page, 1).tap();
  await idle(page);
  await touch(page, [
    [
      [x, y],
      [x + 10, y + 10],
      [x + 25, y + 30],
      [x + 30, y + 40],
    ],
  ]);
  await idle(page);
  expect(await picture(page)).not.toBe(near);
  expect(new Set(await photos(page)).size).toBe(4);
});

test('two photos are swapped by taps and by a drag', async ({ page }) => {
  await openFour(page);
  const before = await photos(page);
  await panel(page, 2).tap();
  await (await reach(page, 'Swap photo')).tap();
  await panel(page, 3).tap();
  await idle(page);
  expect(await photos(page)).toEqual([before[0], before[2], before[1], before[3]]);
  await panel(page, 1).tap();
  const [from, to] = [await middle(page, 1), await middle(page, 4)];
  await touch(page, [[...way(from, to, 2), to]]);
  await idle(page);
  expect(await photos(page)).toEqual([before[3], before[2], before[1], before[0]]);
});

test('a photo is put into a panel, and Shuffle does not change the locked panel', async ({ page }) => {
  await openFour(page);
  const before = await photos(page);
  await panel(page, 1).tap();
  await page.getByRole('button', { name: 'Photos', exact: true }).tap();
  const put = page.getByRole('button', { name: /^Put .* in panel 1$/ });
  const names = await put.evaluateAll((list) => list.map((button) => String(button.getAttribute('aria-label'))));
  const other = names.findIndex((name) => !before.some((photo) => name.includes(String(photo))));
  await put.nth(other).tap();
  await idle(page);
  const after = await photos(page);
  expect(names[other]).toContain(String(after[0]));
  expect(after.slice(1)).toEqual(before.slice(1));
  await page.getByRole('button', { name: 'Close' }).tap();
  await page.getByRole('button', { name: 'Lock', exact: true }).tap();
  await page.getByRole('button', { name: 'Shuffle', exact: true }).tap();
  await idle(page);
  expect((await photos(page))[0]).toBe(after[0]);
});

test('a slider changes along its track, and not during scrolling', async ({ page }) => {
  await openBoard(page);
  await page.setViewportSize({ width: 360, height: 640 });
  await page.getByRole('button', { name: 'Menu', exact: true }).tap();
  await page.getByRole('button', { name: 'Page settings' }).tap();
  const slider = page.getByRole('slider', { name: 'Margin' });
  const before = await slider.inputValue();
  /** @returns {Promise<Point>} a point of the track far from the handle */
  const place = async () => {
    // A trial click waits until the drawer and the scrolling do not move.
    await slider.click({ trial: true });
    const box = await slider.boundingBox();
    return box ? [box.x + box.width * 0.8, box.y + box.height / 2] : [0, 0];
  };
  let [x, y] = await place();
  await touch(page, [way([x, y], [x, y - 88], 11)]);
  await idle(page);
  expect(await slider.inputValue()).toBe(before);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  [x, y] = await place();
  await touch(page, [way([x, y], [x - 42, y], 7)]);
  await idle(page);
  expect(await slider.inputValue()).not.toBe(before);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled();
});

test('the whole photo is shown around its panel while it is cropped', async ({ page }) => {
  await openFour(page);
  const ghost = page.locator('.crop-ghost');
  await panel(page, 3).tap();
  await (await reach(page, 'Crop')).tap();
  await expect(ghost.locator('[data-drawn=true]')).toBeVisible();
  await page.getByRole('button', { name: 'Done', exact: true }).tap();
  await expect(ghost).toHaveCount(0);
  // A finger that drags the photo of a selected panel.
  const [x, y] = await middle(page, 3);
  await page.evaluate(() => {
    new MutationObserver(() => {
      if (document.querySelector('.crop-ghost')) document.body.dataset.ghost = 'seen';
    }).observe(document.body, { childList: true, subtree: true });
  });
  await touch(page, [way([x, y], [x + 20, y + 20])]);
  await idle(page);
  await expect(page.locator('body')).toHaveAttribute('data-ghost', 'seen');
  await expect(ghost).toHaveCount(0);
});
