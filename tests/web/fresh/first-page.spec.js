// @ts-check
/** The first steps of a new user: open the app, try the sample album, download the page. */

import { readFile } from 'node:fs/promises';
import { PNG, expect, test } from '../../../www/testing.ts';

/** The default page: A4 at 300 DPI, in pixels. */
const SIZE = { width: 2480, height: 3508 };

/** A page of photos has more bytes than an empty sheet of paper. */
const MIN_BYTES = 500_000;

test('a fresh checkout makes a page of the sample album and detects faces', async ({ page }) => {
  await page.goto('./');
  await page.getByRole('button', { name: 'Try the sample album' }).click();
  await expect(page.locator('body')).toHaveAttribute('data-idle', 'true', { timeout: 120_000 });
  // The detector module is still being compiled when the page is served.
  await expect(page.locator('body')).toHaveAttribute('data-detected', 'true', { timeout: 500_000 });
  await page.locator('.context-bar').getByRole('button', { name: 'More', exact: true }).click();
  await page.getByRole('button', { name: 'Show subjects', exact: true }).click();
  // Four of the 19 photos show people, so a page can be without faces.
  await expect(async () => {
    await page.getByRole('button', { name: 'Shuffle', exact: true }).click();
    await expect(page.locator('.page .subject-boxes rect[data-label="face"]').first()).toBeAttached({
      timeout: 10_000,
    });
  }).toPass({ timeout: 240_000 });

  const download = page.waitForEvent('download', { timeout: 120_000 });
  await page.getByRole('button', { name: 'Download PNG', exact: true }).click();
  const bytes = await readFile(await (await download).path());
  const { width, height } = PNG.sync.read(bytes);
  expect({ width, height }).toEqual(SIZE);
  expect(bytes.length).toBeGreaterThan(MIN_BYTES);
});
