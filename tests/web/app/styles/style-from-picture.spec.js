// @ts-check
/** Styles found for the look of a picture. */

import { readFile } from 'node:fs/promises';
import { FOUR } from '../style-designer.js';
import { accessible, drop, expect, idle, openBoard, photos, test } from '../support.js';

test('styles are found for a picture that is dropped with Alt, and one is saved and used', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Style from a picture', exact: true }).click();
  const region = page.getByRole('region', { name: 'Style from a picture' });
  await expect(region.getByText('Choose a picture with the look that you want', { exact: false })).toBeVisible();

  // The app reports that a plain photo has no style.
  await region.getByLabel('Picture with the style that you want').setInputFiles(await photos('raccoon.jpg'));
  await expect(region.getByText('This looks like a plain photo', { exact: false })).toBeVisible({ timeout: 90_000 });
  // The photo is shown without a style.
  await expect(region.locator('.imitation-result canvas[data-drawn=true]')).toBeVisible();

  const buffer = await readFile(new URL('../../../../docs/pages/noir.png', import.meta.url));
  await drop(page, [{ name: 'dark print.png', mimeType: 'image/png', buffer }], { altKey: true });
  await expect(region.getByRole('progressbar')).toBeVisible();
  const found = region.getByRole('list', { name: 'Styles found' }).getByRole('button');
  await expect(found.first()).toBeVisible({ timeout: 180_000 });
  await expect(region).toHaveAttribute('aria-busy', 'false');
  expect(await found.count()).toBeGreaterThanOrEqual(3);
  expect(await found.count()).toBeLessThanOrEqual(6);
  await expect(region.getByRole('img', { name: 'Like dark print 1 on', exact: false })).toBeVisible();
  await found.nth(1).focus();
  await page.keyboard.press('Enter');
  await expect(found.nth(1)).toHaveAttribute('aria-pressed', 'true');
  await accessible(page);

  await region.getByRole('button', { name: 'Save style' }).click();
  await region.getByRole('button', { name: 'Use', exact: true }).click();
  await expect(region).toBeHidden();
  await expect(page.getByRole('option', { name: 'Like dark print 2' })).toHaveAttribute('aria-selected', 'true');
});

test('the search starts while a picture is dragged with Alt', async ({ page }) => {
  await page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (/** @type {any[]} */ ...given) {
      // The first search counts.
      if (given[0]?.op === 'tryLooks') document.body.dataset.tried ??= document.body.dataset.alt ?? 'without Alt';
      return /** @type {any} */ (postMessage).apply(this, given);
    };
  });
  await page.clock.install();
  await openBoard(page, FOUR);
  const transfer = await page.evaluateHandle(() => {
    const made = new DataTransfer();
    made.items.add(new File([], 'dark print.png', { type: 'image/png' }));
    return made;
  });
  const drag = async (/** @type {{ altKey?: boolean }} */ keys = {}) => {
    for (const type of ['dragenter', 'dragover'])
      await page.dispatchEvent('body', type, { dataTransfer: transfer, ...keys });
  };
  // A drag of photos for the page starts no search.
  await drag();
  await page.clock.runFor(5_000);
  await idle(page);
  await expect(page.locator('body')).not.toHaveAttribute('data-tried');
  await page.evaluate(() => {
    document.body.dataset.alt = 'with Alt';
  });
  await drag({ altKey: true });
  await expect(page.locator('body')).toHaveAttribute('data-tried', 'with Alt');
});
