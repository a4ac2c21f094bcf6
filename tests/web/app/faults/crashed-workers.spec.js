// @ts-check
import { test as plain } from '../../../../www/testing.ts';
import { SIX, add, colours, expect, idle, photos, picture, pixelsOf, press } from '../support.js';

// Not the watched test of `support.js`: here errors in workers are the point.

/** @param {import('../../../../www/testing.ts').Page} page */
const crashWorkers = (page) =>
  Promise.all(
    page.workers().map((worker) =>
      worker.evaluate(() => {
        setTimeout(() => {
          throw new Error('a fault made by the test');
        });
      }),
    ),
  );

plain('workers that die in the middle are replaced, and the page is finished', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  await crashWorkers(page);
  await idle(page);
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
  await expect(page.getByRole('alert')).toHaveText('');
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeAttached();
});

plain('workers that die at rest are replaced when they are needed', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  await idle(page);
  await crashWorkers(page);
  await page.waitForTimeout(200);
  const before = await picture(page);
  await press(page, 'Shuffle');
  expect(await picture(page)).not.toBe(before);
});

plain('a program that cannot be loaded says so', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.abort());
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText('Inkpanel could not start');
});
