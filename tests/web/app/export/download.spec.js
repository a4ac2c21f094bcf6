// @ts-check
import { readFile } from 'node:fs/promises';
import { PNG } from '../../../../www/testing.ts';
import { colours, expect, openBoard, press, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/**
 * @param {Page} page
 * @param {() => Promise<void>} act
 * @returns {Promise<{ name: string, png: PNG, bytes: Buffer }>}
 */
async function saved(page, act) {
  const waiting = page.waitForEvent('download', { timeout: 60_000 });
  await act();
  const download = await waiting;
  const bytes = await readFile(await download.path());
  return { name: download.suggestedFilename(), bytes, png: PNG.sync.read(bytes) };
}

const pressDownload = (/** @type {Page} */ page) => () => page.getByRole('button', { name: 'Download PNG' }).click();

test('the PNG has print size, is not blank, and another page gives another PNG', async ({ page }) => {
  await openBoard(page);
  // What is said goes again by itself, perhaps before a file of this size is read.
  const told = expect(page.getByRole('status')).toContainText('saved', { timeout: 150_000 });
  const first = await saved(page, pressDownload(page));
  await told;
  expect(first.name).toMatch(/\d{4}\.png$/);
  expect([first.png.width, first.png.height]).toEqual([2480, 3508]);
  expect(colours(first.png)).toBeGreaterThan(2);
  await press(page, 'Shuffle');
  const second = await saved(page, pressDownload(page));
  expect([second.png.width, second.png.height]).toEqual([2480, 3508]);
  expect(second.png.data.equals(first.png.data)).toBe(false);
});

test('the export dialog saves other sizes', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Export the page' });
  await dialog.getByRole('radio', { name: 'Square' }).check();
  await expect(dialog.locator('canvas[data-drawn=true]')).toBeVisible();
  await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  await expect(dialog.getByText('1200 × 1200 pixels')).toBeVisible();
  const { png } = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  expect([png.width, png.height]).toEqual([1200, 1200]);
  expect(colours(png)).toBeGreaterThan(2);
  await expect(dialog).toBeHidden();
});

test('a download shows its progress and can be cancelled', async ({ page }) => {
  await openBoard(page);
  let downloads = 0;
  page.on('download', () => {
    downloads += 1;
  });
  // A fast machine may be done before anyone has pressed Cancel.
  await expect(async () => {
    downloads = 0;
    await pressDownload(page)();
    await expect(page.getByRole('progressbar', { name: /full size/ })).toBeVisible();
    await page.getByRole('button', { name: 'Cancel' }).press('Enter', { timeout: 1500 });
    await expect(page.getByRole('progressbar', { name: /full size/ })).toHaveCount(0);
    await page.waitForTimeout(1500);
    expect(downloads).toBe(0);
  }).toPass();
  // The page lives on.
  await press(page, 'Shuffle');
});
