// @ts-check
import { contents, expect, idle, openBoard, picture, test } from '../support.js';

/** @param {import('../../../../www/testing.ts').Page} page */
const drawn = (page) => page.getByRole('region', { name: 'Alternatives' }).locator('canvas[data-drawn=true]');

test('at least fourteen pages are in view on a large screen, more as one scrolls', async ({ page }) => {
  await page.setViewportSize({ width: 1920, height: 1080 });
  await openBoard(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThanOrEqual(14);
  const inView = await drawn(page).evaluateAll(
    (list) =>
      list.filter((canvas) => {
        const { left, right, bottom } = canvas.getBoundingClientRect();
        return left >= 0 && right <= innerWidth && bottom <= innerHeight;
      }).length,
  );
  expect(inView).toBeGreaterThanOrEqual(14);
  const region = page.getByRole('region', { name: 'Alternatives' });
  const before = await region.getByRole('button').count();
  for (let i = 0; i < 3; i += 1) {
    await region.getByRole('list').evaluate((list) => list.scrollTo({ left: list.scrollWidth }));
    await page.waitForTimeout(150);
  }
  await expect.poll(() => region.getByRole('button').count()).toBeGreaterThan(before);
});

test('a click makes an alternative the page, and the stream stays', async ({ page }) => {
  await openBoard(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  const before = await picture(page);
  const third = page.getByRole('button', { name: 'Alternative 3', exact: true });
  const thumbnail = await third.locator('canvas').elementHandle();
  await third.click();
  await idle(page);
  expect(await picture(page)).not.toBe(before);
  await expect(third).toHaveAttribute('aria-current', 'true');
  expect(await thumbnail?.evaluate((canvas) => canvas.isConnected)).toBe(true);
  await page.getByRole('button', { name: 'Undo' }).click();
  await idle(page);
  expect(await picture(page)).toBe(before);
});

test('alternatives respect the locks', async ({ page }) => {
  await openBoard(page);
  const { style } = await contents(page);
  await page.getByRole('button', { name: 'Lock style' }).click();
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  for (const number of [1, 2, 3]) {
    await page.getByRole('button', { name: `Alternative ${number}`, exact: true }).click();
    await idle(page);
    expect((await contents(page)).style).toBe(style);
  }
});

test('Enter chooses, too', async ({ page }) => {
  await openBoard(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  const before = await picture(page);
  await page.getByRole('button', { name: 'Alternative 2', exact: true }).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  expect(await picture(page)).not.toBe(before);
});
