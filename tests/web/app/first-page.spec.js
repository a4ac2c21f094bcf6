// @ts-check
/** The first page: empty panels until its photos are known, then one page that does not change by itself. */

import { SIX, add, detectingTest, expect, idle, photos, picture, test } from './support.js';

/** What each panel shows, as told to who does not see it. */
const shown = (/** @type {import('./support.js').Page} */ page) =>
  page
    .locator('.stage [aria-description]')
    .evaluateAll((all) => all.map((one) => one.getAttribute('aria-description')));

const MORE = ['camera.jpg', 'dahlia.jpg', 'horses.jpg', 'orchestra.jpg', 'pagoda.jpg', 'palace.jpg'];

test('is there when its photos are, and stays while the others are read', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX, ...MORE));
  await page.waitForFunction(() => document.body.dataset.drawn === 'true');
  const first = await shown(page);
  expect(first).toHaveLength(6);
  await idle(page);
  expect(await shown(page)).toEqual(first);
});

test('is not one step of the undo, and Shuffle makes another', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  await idle(page);
  await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeDisabled();
  await page.getByRole('button', { name: 'Shuffle', exact: true }).click();
  await idle(page);
  await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeEnabled();
});

detectingTest('offers what is found after it was looked at, and never takes it by itself', async ({ page }) => {
  // The nets come late, as over a slow connection.
  await page.route(/nets-[^/]*\.wasm$/, async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 6000));
    await route.continue();
  });
  await page.goto('./');
  await add(page, await photos(...MORE));
  await page.waitForFunction(() => document.body.dataset.drawn === 'true');
  const offer = page.getByRole('button', { name: 'Improve crops' });
  const before = await picture(page);
  await page.waitForFunction(() => document.body.dataset.detected === 'true', undefined, { timeout: 60_000 });
  if (await offer.isVisible()) {
    expect(await picture(page)).toEqual(before);
    await offer.click();
    await expect(offer).toBeHidden();
    await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeEnabled();
  } else {
    expect(await picture(page)).toEqual(before);
  }
});
