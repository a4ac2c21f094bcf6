// @ts-check
/** Print resolution: panels with a low resolution, and the check box that upscales them. */

import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { PNG } from '../../../../www/testing.ts';
import { chooseFormat, openExport, saved } from '../export-dialog.js';
import { expect, openBoard, sharedBoardTest as test } from '../support.js';

const run = promisify(execFile);

/** @typedef {import('../support.js').Page} Page */
/** @typedef {ReturnType<Page['getByRole']>} Locator */

/** The check box that upscales photos. @param {Locator} dialog */
const box = (dialog) => dialog.getByRole('checkbox', { name: 'Upscale low-resolution photos' });

/** The page as Poppler draws it, saved from the dialog. @param {Page} page @param {Locator} dialog */
async function savedPage(page, dialog) {
  const { path } = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  const { stdout } = await run('pdftoppm', ['-png', '-r', '300', path], { encoding: 'buffer', maxBuffer: 1 << 28 });
  return PNG.sync.read(stdout);
}

/** Opens the dialog, and chooses a PDF file for print. @param {Page} page */
async function openPrint(page) {
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'print');
  return dialog;
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
  const dialog = await openPrint(page);
  await expect(dialog.getByRole('button', { name: /^Panel 1: \d+ dpi$/ })).toBeVisible();
  await expect(box(dialog)).not.toBeChecked();
  const plain = await savedPage(page, dialog);
  // The dialog closes after the file is saved. Its options apply to one file.
  const next = await openPrint(page);
  await box(next).check();
  await expect(next.getByText('upscaled with sharper edges')).toBeVisible();
  const sharp = await savedPage(page, next);
  expect(apart(plain, sharp)).toBeGreaterThan(20_000);
  const last = await openPrint(page);
  await expect(box(last)).not.toBeChecked();
  expect(apart(plain, await savedPage(page, last))).toBe(0);
});

test('a file for print has bleed and crop marks, and the resolution names its unit', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  const dialog = await openPrint(page);
  await expect(dialog.getByRole('combobox', { name: 'Bleed' })).toHaveValue('mm3');
  await expect(dialog.getByRole('checkbox', { name: 'Crop marks' })).toBeChecked();
  const resolution = dialog.getByRole('combobox', { name: 'Resolution' }).getByRole('option');
  await expect(resolution).toHaveText(['300 dpi', '150 dpi, half size']);
  const { path } = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  const { stdout } = await run('pdfinfo', ['-box', path]);
  const side = (/** @type {string} */ name) => {
    const [left, , right] = (stdout.match(new RegExp(`${name}: +(.*)`))?.[1] ?? '').trim().split(/ +/).map(Number);
    return right - left;
  };
  // Points. The sheet also has the marks.
  expect(side('BleedBox') - side('TrimBox')).toBeCloseTo((2 * 3 * 72) / 25.4, 0);
  expect(side('MediaBox')).toBeGreaterThan(side('BleedBox'));
});

test('only files for print have a check of the print resolution', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  const dialog = await openPrint(page);
  await expect(box(dialog)).toBeVisible();
  for (const way of ['png', 'jpeg', 'pdf', 'html', 'cbz', 'project']) {
    await chooseFormat(dialog, way);
    await expect(box(dialog), way).toHaveCount(0);
  }
});

test('a size for screens has no check of the print resolution', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  const dialog = await openPrint(page);
  await expect(box(dialog)).toBeVisible();
  await dialog.getByText('Page size: ').click();
  await dialog.getByRole('radio', { name: /^Story/ }).check();
  await expect(box(dialog)).toHaveCount(0);
});
