// @ts-check
import { readFile } from 'node:fs/promises';
import { FOUR } from '../designer-hands.js';
import { accessible, drop, expect, openBoard, photos, test } from '../support.js';

test('a style is taken over from a picture that is dropped with Alt, used on the page, and saved', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Style from a picture', exact: true }).click();
  const region = page.getByRole('region', { name: 'Style from a picture' });
  await expect(region.getByText('Choose a picture whose look you want', { exact: false })).toBeVisible();

  // A plain photo has nothing to take over, which is said.
  await region.getByLabel('Picture whose style is wanted').setInputFiles(await photos('raccoon.jpg'));
  await expect(region.getByText('This looks like a plain photo', { exact: false })).toBeVisible({ timeout: 90_000 });
  // The photo that styles are tried on is seen as it is.
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

test('the search begins while a picture is still dragged for its style', async ({ page }) => {
  await page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (/** @type {any[]} */ ...given) {
      if (given[0]?.op === 'tryLooks') document.body.dataset.tried = 'true';
      return /** @type {any} */ (postMessage).apply(this, given);
    };
  });
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
  // Photos for the page are no reason to search.
  await drag();
  await page.waitForTimeout(500);
  await expect(page.locator('body')).not.toHaveAttribute('data-tried');
  await drag({ altKey: true });
  await expect(page.locator('body')).toHaveAttribute('data-tried', 'true');
});
