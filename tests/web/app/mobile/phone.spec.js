// @ts-check
import { expect, idle, openBoard, picture, press, test } from '../support.js';

test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, deviceScaleFactor: 2 });

/** @param {import('../../../../www/testing.ts').Page} page */
const overflow = (page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

test('the page fills a narrow screen, and nothing sticks out', async ({ page }) => {
  await page.goto('./');
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

test('shuffle and the sheets are under the thumb, with the page in view', async ({ page }) => {
  await openBoard(page);
  const before = await picture(page);
  await press(page, 'Shuffle');
  expect(await picture(page)).not.toBe(before);
  for (const [tab, list] of [
    ['Styles', 'Styles'],
    ['Layouts', 'Layouts'],
  ]) {
    await page.getByRole('button', { name: tab, exact: true }).click();
    const box = page.getByRole('listbox', { name: list });
    await expect(box).toBeVisible();
    await idle(page);
    const page1 = await picture(page);
    await box.getByRole('option', { selected: false }).first().click();
    await idle(page);
    expect(await picture(page)).not.toBe(page1);
    const canvas = await page.locator('.page-canvas').boundingBox();
    expect(canvas?.height).toBeGreaterThan(150);
    await page.getByRole('button', { name: 'Close' }).click();
  }
});

test('a swipe turns to another page, and back', async ({ page }) => {
  await openBoard(page);
  const first = await picture(page);
  await swipe(page, -200);
  await idle(page);
  const second = await picture(page);
  expect(second).not.toBe(first);
  await swipe(page, 200);
  await idle(page);
  expect(await picture(page)).toBe(first);
  await swipe(page, -200);
  await idle(page);
  expect(await picture(page)).toBe(second);
});

/**
 * @param {import('../../../../www/testing.ts').Page} page
 * @param {number} by pixels to the right
 */
async function swipe(page, by) {
  const box = await page.locator('.page-canvas').boundingBox();
  if (!box) throw new Error('no page');
  const client = await page.context().newCDPSession(page);
  const y = box.y + box.height / 2;
  const from = box.x + box.width / 2 - by / 2;
  const touch = (/** @type {'touchStart' | 'touchMove' | 'touchEnd'} */ type, /** @type {number} */ x) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y }] });
  await touch('touchStart', from);
  for (let i = 1; i <= 5; i += 1) await touch('touchMove', from + (by * i) / 5);
  await touch('touchEnd', from + by);
}
