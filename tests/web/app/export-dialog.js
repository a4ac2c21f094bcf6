// @ts-check
/** The export dialog, and the files that it saves. */

import { readFile } from 'node:fs/promises';

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** @param {Page} page */
export async function openExport(page) {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  return page.getByRole('dialog', { name: 'Export' });
}

/** The kind and the format of each choice of the export dialog. */
export const WAYS = /** @type {Record<string, [kind: string, format?: string]>} */ ({
  png: ['Image', 'PNG'],
  jpeg: ['Image', 'JPEG'],
  webp: ['Image', 'WebP'],
  pdf: ['PDF'],
  print: ['Print'],
  html: ['Comic', 'HTML comic'],
  epub: ['Comic', 'EPUB'],
  cbz: ['Comic', 'CBZ'],
  strip: ['Comic', 'Webtoon strip'],
  animatic: ['Video', 'Animatic'],
  motion: ['Video', 'Motion comic'],
  project: ['Project'],
  csv: ['More', 'Shot list'],
  edl: ['More', 'EDL'],
  otio: ['More', 'OTIO'],
  xml: ['More', 'Final Cut XML'],
});

/**
 * Chooses a format in the export dialog.
 * @param {import('../../../www/testing.ts').Locator} dialog
 * @param {string} way a key of `WAYS`
 */
export async function chooseFormat(dialog, way) {
  for (const name of WAYS[way]) if (name) await dialog.getByRole('radio', { name, exact: true }).check();
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
 * @param {{ quality?: number, half?: boolean, project?: boolean }} [how] `project`: it contains the project
 */
export async function savedAs(page, format, { quality, half = true, project = false } = {}) {
  const dialog = await openExport(page);
  await chooseFormat(dialog, format);
  if (half) await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
  if (project) await dialog.getByRole('radio', { name: 'Editing again on this device' }).check();
  if (quality !== undefined) await dialog.getByRole('slider', { name: 'Image quality' }).fill(String(quality));
  return saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
}
