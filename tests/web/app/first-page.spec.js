// @ts-check
/** The first page: empty panels until its photos are measured, then a page that only the user changes. */

import { SIX, add, detectingTest, expect, idle, photos, picture, test } from './support.js';

/** Returns the accessible descriptions of the panels. */
const shown = (/** @type {import('./support.js').Page} */ page) =>
  page
    .locator('.stage [aria-description]')
    .evaluateAll((all) => all.map((one) => one.getAttribute('aria-description')));

const MORE = ['camera.jpg', 'dahlia.jpg', 'horses.jpg', 'orchestra.jpg', 'pagoda.jpg', 'palace.jpg'];

test('the first page is shown when its photos are ready, and stays while other photos are read', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX, ...MORE));
  await page.waitForFunction(() => document.body.dataset.drawn === 'true');
  const first = await shown(page);
  expect(first).toHaveLength(6);
  await idle(page);
  expect(await shown(page)).toEqual(first);
});

test('the first page is no undo step, and the next Shuffle is one', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  await idle(page);
  await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeDisabled();
  await page.getByRole('button', { name: 'Shuffle', exact: true }).click();
  await idle(page);
  await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeEnabled();
});

detectingTest(
  'better crops are offered if the user has seen the page, and are not applied without a click',
  async ({ page }) => {
    let release = () => {};
    const held = new Promise((resolve) => {
      release = () => resolve(undefined);
    });
    await page.route(/nets-[^/]*\.wasm$/, async (route) => {
      await held;
      await route.continue();
    });
    await page.goto('./');
    await add(page, await photos(...MORE));
    await page.waitForFunction(() => document.body.dataset.drawn === 'true');
    const before = await picture(page);
    // After ten seconds on the screen, the first page does not change automatically any more.
    await page.evaluate(() => {
      const now = performance.now.bind(performance);
      performance.now = () => now() + 11_000;
    });
    release();
    await page.waitForFunction(() => document.body.dataset.detected === 'true', undefined, { timeout: 120_000 });
    const offer = page.getByRole('button', { name: 'Improve crops' });
    await expect(offer).toBeVisible();
    expect(await picture(page)).toEqual(before);
    await offer.click();
    await expect(offer).toBeHidden();
    await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeEnabled();
  },
);
