// @ts-check
/** The first page: empty panels until its photos are measured, then a page that only the user changes. */

import { readFile } from 'node:fs/promises';
import { reloadSaved } from './project-files.js';
import { SIX, add, detectingTest, expect, idle, photos, picture, test } from './support.js';

/** Returns the accessible descriptions of the panels. */
const shown = (/** @type {import('./support.js').Page} */ page) =>
  page
    .locator('.stage [aria-description]')
    .evaluateAll((all) => all.map((one) => one.getAttribute('aria-description')));

const ALBUM = new URL('../../../www/public/samples/', import.meta.url);
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

test('drafts of large photos are replaced in the panels', async ({ page }) => {
  // Comments make the files large.
  const comment = Buffer.concat([Buffer.from([0xff, 0xfe, 0xff, 0xff]), Buffer.alloc(65_533)]);
  const names = ['01-coffee', '04-dandelions', '06-castle', '11-giraffe'];
  const files = names.map(async (name) => {
    const file = await readFile(new URL(`${name}.jpg`, ALBUM));
    const buffer = Buffer.concat([file.subarray(0, 2), ...Array(8).fill(comment), file.subarray(2)]);
    return { name: `${name}.jpg`, mimeType: 'image/jpeg', buffer };
  });
  await page.goto('./');
  await add(page, await Promise.all(files));
  await idle(page);
  const first = await picture(page);
  // A stored photo has no draft.
  await reloadSaved(page);
  expect(await picture(page)).toBe(first);
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
