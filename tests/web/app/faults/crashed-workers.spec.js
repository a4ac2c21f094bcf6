// @ts-check
/** Workers that crash, and an engine that cannot be loaded. */

import { SIX, add, colours, expect, faultTest as test, idle, photos, picture, pixelsOf, press } from '../support.js';

/** Throws an error in each worker, and waits until it was thrown. @param {import('../support.js').Page} page */
const crashWorkers = (page) =>
  Promise.all(
    page.workers().map((worker) =>
      worker
        .evaluate(
          () =>
            new Promise((resolve) => {
              setTimeout(() => {
                setTimeout(resolve);
                throw new Error('an error of the test');
              });
            }),
        )
        // The app may have terminated the worker.
        .catch(() => {}),
    ),
  );

test('workers that crash during a job are replaced, and the page is finished', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  await crashWorkers(page);
  await idle(page);
  expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
  await expect(page.getByRole('alert')).toHaveText('');
  for (const name of SIX) await expect(page.getByRole('checkbox', { name: `Use ${name}` })).toBeAttached();
});

test('workers that crash without a job are replaced when they are needed', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos(...SIX));
  await idle(page);
  await crashWorkers(page);
  const before = await picture(page);
  await press(page, 'Shuffle');
  expect(await picture(page)).not.toBe(before);
});

test('an engine that cannot be loaded is reported', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.abort());
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText('Inkpanel could not start');
});
