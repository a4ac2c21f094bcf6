// @ts-check
/** Axe on every screen, in light and dark, wide and small. */

import { readFile } from 'node:fs/promises';
import { lookAtScreens, openFour } from './screens.js';
import { accessible, add, expect, idle, offences, test } from './support.js';

/** What another colour scheme may change; all else axe has found in the first one, or has not. */
const COLOURS = ['color-contrast', 'link-in-text-block'];

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  for (const [width, height] of [
    [1280, 800],
    [360, 740],
  ]) {
    test.describe(`in ${colorScheme}, ${width} wide`, () => {
      test.use({ colorScheme, viewport: { width, height } });

      test('axe finds nothing on any screen', async ({ page }) => {
        test.slow();
        page.setDefaultTimeout(15_000);
        /** All screens are gone through before the test fails. @type {Record<string, unknown>} */
        const wrong = {};
        const look = async (/** @type {string} */ name) => {
          const found = await offences(page, colorScheme === 'dark' ? COLOURS : undefined);
          if (found.length > 0) wrong[name] = found;
        };
        await page.goto('./');
        await idle(page);
        await look('start');
        await page.getByRole('button', { name: 'Projects' }).click();
        await look('no projects');
        await openFour(page);
        await lookAtScreens(page, look, wrong);
        expect(wrong).toEqual({});
      });
    });
  }
}

test('axe finds nothing on a video and its stretch, nor while it is read', async ({ page }) => {
  await page.goto('./');
  await add(page, [
    {
      name: 'album.mp4',
      mimeType: 'video/mp4',
      buffer: await readFile(new URL('../../videos/album.mp4', import.meta.url)),
    },
  ]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await accessible(page);
  await idle(page);
  await page.locator('.video summary').click();
  await accessible(page);
});
