// @ts-check
/** The check of what is printed: panels whose photos are too coarse, and the box that has these enlarged well. */

import { PNG } from '../../../../www/testing.ts';
import { openExport, saved } from '../export-hands.js';
import { add, expect, idle, photos, test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */
/** @typedef {ReturnType<Page['getByRole']>} Locator */

/** The check box. @param {Locator} dialog */
const box = (dialog) => dialog.getByRole('checkbox', { name: 'Enlarge well' });

/** The page as a PNG, saved from the dialog. @param {Page} page @param {Locator} dialog */
async function savedPng(page, dialog) {
  const { bytes } = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  return PNG.sync.read(bytes);
}

/** How many samples of two pictures of one size are clearly apart. @param {PNG} a @param {PNG} b */
function apart(a, b) {
  expect([b.width, b.height]).toEqual([a.width, a.height]);
  let count = 0;
  for (let i = 0; i < a.data.length; i += 1) if (Math.abs(a.data[i] - b.data[i]) > 16) count += 1;
  return count;
}

test('a panel below the resolution of print is enlarged well where the box is ticked, for this export alone', async ({
  page,
}) => {
  await page.goto('./');
  await add(page, await photos('cat.jpg'));
  await idle(page);
  const dialog = await openExport(page);
  await expect(dialog.getByRole('button', { name: /^Panel 1: \d+ dpi$/ })).toBeVisible();
  await expect(box(dialog)).not.toBeChecked();
  const plain = await savedPng(page, dialog);
  // It is closed once the file is saved, and what was chosen in it is chosen for one file.
  const next = await openExport(page);
  await next.getByRole('combobox', { name: 'Format' }).selectOption('png');
  await box(next).check();
  await expect(next.getByText('enlarged with sharper edges')).toBeVisible();
  const sharp = await savedPng(page, next);
  expect(apart(plain, sharp)).toBeGreaterThan(20_000);
  const last = await openExport(page);
  await expect(box(last)).not.toBeChecked();
  expect(apart(plain, await savedPng(page, last))).toBe(0);
});

test('a size for screens asks nothing of the kind', async ({ page }) => {
  await page.goto('./');
  await add(page, await photos('cat.jpg'));
  await idle(page);
  const dialog = await openExport(page);
  await expect(box(dialog)).toBeVisible();
  await dialog.getByRole('radio', { name: /^Story/ }).check();
  await expect(box(dialog)).toHaveCount(0);
});
