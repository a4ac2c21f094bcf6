// @ts-check
/** The export dialog, and the files that it saves. */

import { readFile } from 'node:fs/promises';

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** @param {Page} page */
export async function openExport(page) {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  return page.getByRole('dialog', { name: 'Export the page' });
}

/**
 * Returns the file that an action saves.
 * @param {Page} page
 * @param {() => Promise<void>} act
 * @returns {Promise<{ name: string, path: string, bytes: Buffer }>}
 */
export async function saved(page, act) {
  const waiting = page.waitForEvent('download', { timeout: 90_000 });
  await act();
  const download = await waiting;
  const path = await download.path();
  return { name: download.suggestedFilename(), path, bytes: await readFile(path) };
}

/**
 * Saves the page by the button above it.
 * @param {Page} page
 */
export const download = (page) => saved(page, () => page.getByRole('button', { name: 'Download PNG' }).click());

/**
 * Saves the page as a kind of file.
 * @param {Page} page
 * @param {string} format
 * @param {{ quality?: number, half?: boolean }} [how]
 */
export async function savedAs(page, format, { quality, half = true } = {}) {
  const dialog = await openExport(page);
  if (half) await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption(format);
  if (quality !== undefined) await dialog.getByRole('slider', { name: 'Image quality' }).fill(String(quality));
  return saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
}
