// @ts-check
/** Animatics in the real app: encoded 1080p frames per second, from the click to the file. */

import { statSync } from 'node:fs';

import { chooseFormat, openExport } from '../tests/web/app/export-dialog.js';
import { opened } from './opened.js';

/** @typedef {import('playwright-core').Browser} Browser */
/** @typedef {{ kind: string, frames: number, ms: number, bytes: number }} Film */

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths; each photo becomes a shot of two seconds
 * @returns {Promise<Film[]>}
 */
export async function animatic(browser, address, photos) {
  const page = await opened(browser, address, photos);
  const films = [];
  for (const kind of ['mp4', 'webm']) {
    const dialog = await openExport(page);
    await chooseFormat(dialog, 'animatic');
    await dialog.getByRole('combobox', { name: 'File' }).selectOption(kind);
    const save = dialog.getByRole('button', { name: 'Download' });
    await page.waitForFunction(() =>
      document.querySelector('.animatic canvas')?.getAttribute('aria-label')?.includes('of 0:'),
    );
    const coming = page.waitForEvent('download', { timeout: 600_000 });
    const start = Date.now();
    await save.click();
    const path = await (await coming).path();
    films.push({ kind, frames: photos.length * 2 * 24, ms: Date.now() - start, bytes: statSync(path).size });
  }
  await page.close();
  return films;
}
