// @ts-check
/**
 * Makes and saves projects and pages with the same user actions as the browser tests. See README.md for the command.
 */

import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { openExport, saved } from '../../web/app/export-dialog.js';
import { panel } from '../../web/app/panels.js';
import { add, choose, drop, idle, openBoard, press, test } from '../../web/app/support.js';
import { write } from '../../web/app/text-items.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** Folder of the current version. Folders of older versions do not change. */
const OUT = new URL('version-1/', import.meta.url);
const SMALL = ['bee.jpg', 'cat.jpg', 'dahlia.jpg', 'macaw.jpg', 'camera.jpg'];
const OWN = { id: 'own', name: 'Own', tags: ['ink'], background: [{ block: 'posterize', levels: 4 }, { block: 'saturation', amount: 1.7 }], foreground: [{ block: 'to_gray' }, { block: 'xdog', sigma: 1.1 }], ink: '#203050' };

/** @param {string} name @param {Buffer} bytes */
async function keep(name, bytes) {
  await mkdir(OUT, { recursive: true });
  await writeFile(new URL(name, OUT), bytes);
}

/** @param {Page} page @param {number} width @param {number} height */
async function sized(page, width, height) {
  const settings = page.getByRole('region', { name: 'Page settings' });
  if (!await settings.isVisible()) await page.getByText('Page settings', { exact: true }).first().click();
  await settings.getByLabel('Page size').selectOption('custom');
  await settings.getByLabel('Unit').selectOption('px');
  await settings.getByLabel('Width').fill(String(width));
  await settings.getByLabel('Height').fill(String(height));
  await settings.getByLabel('Dots an inch').fill('150');
  await idle(page);
}

/** @param {Page} page @param {string} name */
async function styled(page, name) {
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name, exact: true }).click();
  await idle(page);
}

/** @param {Page} page @param {string} cargo */
async function exported(page, cargo) {
  const dialog = await openExport(page);
  await dialog.getByRole('radio', { name: cargo }).check();
  return (await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click())).bytes;
}

test('a page with a merge, words and settings of its own', async ({ page }) => {
  await openBoard(page, SMALL.slice(0, 4));
  await sized(page, 360, 480);
  await choose(page, 'grid', 'Four');
  await styled(page, 'Comic');
  await panel(page, 1).click();
  await panel(page, 2).click({ modifiers: ['ControlOrMeta'] });
  await press(page, 'Merge');
  await write(page, 'balloon', 'WHO IS THERE?');
  await write(page, 'caption', 'Later ...');
  await write(page, 'sound effect', 'BUZZ');
  await keep('merged-words.png', await exported(page, 'With photos'));
});

test('a page with a style of its own, a drawn layout and a crop by hand', async ({ page }) => {
  await openBoard(page, SMALL.slice(0, 3));
  await sized(page, 400, 300);
  await press(page, 'New layout');
  await drop(page, [{ name: 'own.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(OWN)) }]);
  await page.getByRole('region', { name: 'Style designer' }).getByRole('button', { name: 'Use', exact: true }).click();
  await idle(page);
  await panel(page, 1).focus();
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('+');
  await idle(page);
  await keep('own-style.png', await exported(page, 'With photos'));
});

test('a storyboard of several pages', async ({ page }) => {
  await openBoard(page, SMALL);
  await page.getByLabel('Project name').fill('Garden');
  await page.keyboard.press('Enter');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('2');
  await idle(page);
  await styled(page, 'Watercolour');
  await sized(page, 240, 320);
  await press(page, 'Add page');
  const thumbs = page.getByRole('region', { name: 'Pages', exact: true }).getByRole('button', { name: /^Page \d+ of \d+$/ });
  const count = await thumbs.count();
  for (let n = 1; n <= count; n += 1) {
    await thumbs.nth(n - 1).click();
    await idle(page);
    if (n === 2) await styled(page, 'Ben Day');
    await keep(`storyboard-${n}.png`, await exported(page, 'Without project data'));
  }
  await thumbs.nth(1).click();
  await idle(page);
  await page.getByRole('button', { name: 'Projects', exact: true }).click();
  const { bytes } = await saved(page, () => page.getByRole('button', { name: 'Save project' }).click());
  await keep('storyboard.inkpanel', bytes);
});

test('a film', async ({ page }) => {
  const buffer = await readFile(new URL('../../videos/album.mp4', import.meta.url));
  await page.goto('./');
  await add(page, [{ name: 'album.mp4', mimeType: 'video/mp4', buffer }]);
  await idle(page);
  await page.getByLabel('Project name').fill('Film');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Projects', exact: true }).click();
  const { bytes } = await saved(page, () => page.getByRole('button', { name: 'Save project' }).click());
  await keep('film.inkpanel', bytes);
});
