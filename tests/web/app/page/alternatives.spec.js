// @ts-check
/** The suggestions below the page, and the space that the page has. */

import { reloadSaved } from '../project-files.js';
import {
  contents,
  expect,
  idle,
  openBoard,
  openNewBoard,
  picture,
  press,
  reach,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

// A window of this height shows the suggestions.
test.use({ viewport: { width: 1366, height: 1024 } });

/** @param {Page} page */
const drawn = (page) => page.getByRole('region', { name: 'Suggestions' }).locator('img[data-drawn=true]');
const alternative = (/** @type {Page} */ page, /** @type {number} */ n) =>
  page.getByRole('button', { name: `Suggestion ${n}`, exact: true });

test('a large screen shows at least 14 alternatives, and scrolling adds more', async ({ page }) => {
  await openBoard(page);
  await page.setViewportSize({ width: 1920, height: 1080 });
  await expect.poll(() => drawn(page).count()).toBeGreaterThanOrEqual(14);
  const inView = await drawn(page).evaluateAll(
    (list) =>
      list.filter((image) => {
        const { left, right, bottom } = image.getBoundingClientRect();
        return left >= 0 && right <= innerWidth && bottom <= innerHeight;
      }).length,
  );
  expect(inView).toBeGreaterThanOrEqual(14);
  const region = page.getByRole('region', { name: 'Suggestions' });
  const before = await region.getByRole('button').count();
  await expect
    .poll(async () => {
      await region.getByRole('list').evaluate((list) => list.scrollTo({ left: list.scrollWidth }));
      return region.getByRole('button').count();
    })
    .toBeGreaterThan(before);
});

test('images in lists are no layers of the compositor', async ({ page }) => {
  await openBoard(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  await expect.poll(() => page.locator('.option img[data-drawn=true]').count()).toBeGreaterThan(3);
  const session = await page.context().newCDPSession(page);
  await session.send('DOM.enable');
  const layers = new Promise((resolve) => {
    session.on('LayerTree.layerTreeDidChange', (event) => event.layers && resolve(event.layers.length));
  });
  await session.send('LayerTree.enable');
  await press(page, 'Shuffle');
  // The window, the page, and the elements above the page.
  expect(await layers).toBeLessThan(20);
});

test('a click makes an alternative the page, and the other alternatives remain', async ({ page }) => {
  await openBoard(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  const before = await picture(page);
  const third = alternative(page, 3);
  const thumbnail = await third.locator('img').elementHandle();
  await third.click();
  await idle(page);
  expect(await picture(page)).not.toBe(before);
  await expect(third).toHaveAttribute('aria-current', 'true');
  expect(await thumbnail?.evaluate((image) => image.isConnected)).toBe(true);
  await press(page, 'Undo');
  expect(await picture(page)).toBe(before);
});

test('Enter makes an alternative the page', async ({ page }) => {
  await openBoard(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  const before = await picture(page);
  await alternative(page, 2).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  expect(await picture(page)).not.toBe(before);
});

test('alternatives keep a locked style', async ({ page }) => {
  await openBoard(page);
  const { style } = await contents(page);
  await page.getByRole('button', { name: 'Lock style' }).click();
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  for (const number of [1, 2, 3]) {
    await alternative(page, number).click();
    await idle(page);
    expect((await contents(page)).style).toBe(style);
  }
});

test('a large view of an alternative has its names, and the page stays', async ({ page }) => {
  await openNewBoard(page);
  const version = page.getByRole('button', { name: /^Page history/ });
  await expect(version).toHaveText('Version 1 of 1');
  await alternative(page, 2).hover();
  await expect(page.locator('.glimpse [data-drawn=true]')).toBeVisible();
  await expect(page.locator('.glimpse-name')).toHaveText(/.+ · .+/);
  await expect(version).toHaveText('Version 1 of 1');
});

test('choosing an alternative closes its large view, also if new alternatives appear under the pointer', async ({
  page,
}) => {
  await openNewBoard(page);
  await alternative(page, 2).hover();
  await expect(page.locator('.glimpse [data-drawn=true]')).toBeVisible();
  await page.mouse.down();
  await page.mouse.up();
  await expect(page.getByRole('button', { name: /^Page history/ })).toHaveText('Version 2 of 2');
  await idle(page);
  await expect.poll(() => drawn(page).count()).toBeGreaterThan(3);
  await expect(page.locator('.glimpse')).toHaveCount(0);
});

test('Shuffle works in full screen, and Escape ends full screen', async ({ page }) => {
  await openNewBoard(page);
  await (await reach(page, 'Full screen')).click();
  await expect(page.getByRole('button', { name: 'Export' })).toBeHidden();
  await page.keyboard.press('Space');
  await idle(page);
  await page.keyboard.press('Escape');
  await expect(page.getByRole('button', { name: /^Page history/ })).toHaveText('Version 2 of 2');
});

test('the alternatives fold to make space for the page, also after a reload', async ({ page }) => {
  await openBoard(page);
  const height = async () => (await page.locator('.page-canvas').boundingBox())?.height ?? 0;
  const before = await height();
  await page.getByRole('button', { name: 'Hide suggestions' }).click();
  await expect(page.getByRole('button', { name: /^Suggestion \d/ })).toHaveCount(0);
  await expect.poll(height).toBeGreaterThan(before + 50);
  await reloadSaved(page);
  await page.getByRole('button', { name: 'Show suggestions' }).click();
  await expect(alternative(page, 1)).toBeVisible();
});

test('the suggestions are folded in a low window', async ({ page }) => {
  await openBoard(page);
  await page.evaluate(() => localStorage.removeItem('inkpanel.ideas'));
  await page.setViewportSize({ width: 1366, height: 768 });
  await reloadSaved(page);
  await expect(page.getByRole('button', { name: 'Show suggestions' })).toBeVisible();
  await expect(page.getByRole('button', { name: /^Suggestion \d/ })).toHaveCount(0);
});
