// @ts-check
/** Print resolution: panels with a low resolution, and the check box that upscales them. */

import { PNG } from '../../../../www/testing.ts';
import { openExport, saved } from '../export-hands.js';
import { expect, openBoard, sharedBoardTest as test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */
/** @typedef {ReturnType<Page['getByRole']>} Locator */

/** The check box that upscales photos. @param {Locator} dialog */
const box = (dialog) => dialog.getByRole('checkbox', { name: 'Upscale low-resolution photos' });

/** The page as a PNG, saved from the dialog. @param {Page} page @param {Locator} dialog */
async function savedPng(page, dialog) {
  const { bytes } = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  return PNG.sync.read(bytes);
}

/** Counts the samples of two images of one size that clearly differ. @param {PNG} a @param {PNG} b */
function apart(a, b) {
  expect([b.width, b.height]).toEqual([a.width, a.height]);
  let count = 0;
  for (let i = 0; i < a.data.length; i += 1) if (Math.abs(a.data[i] - b.data[i]) > 16) count += 1;
  return count;
}

test('a panel with a low resolution is upscaled if the box is checked, for this export only', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  const dialog = await openExport(page);
  await expect(dialog.getByRole('button', { name: /^Panel 1: \d+ dpi$/ })).toBeVisible();
  await expect(box(dialog)).not.toBeChecked();
  const plain = await savedPng(page, dialog);
  // The dialog closes after the file is saved. Its options apply to one file.
  const next = await openExport(page);
  await next.getByRole('combobox', { name: 'Format' }).selectOption('png');
  await box(next).check();
  await expect(next.getByText('upscaled with sharper edges')).toBeVisible();
  const sharp = await savedPng(page, next);
  expect(apart(plain, sharp)).toBeGreaterThan(20_000);
  const last = await openExport(page);
  await expect(box(last)).not.toBeChecked();
  expect(apart(plain, await savedPng(page, last))).toBe(0);
});

test('a size for screens has no check of the print resolution', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  const dialog = await openExport(page);
  await expect(box(dialog)).toBeVisible();
  await dialog.getByRole('radio', { name: /^Story/ }).check();
  await expect(box(dialog)).toHaveCount(0);
});
