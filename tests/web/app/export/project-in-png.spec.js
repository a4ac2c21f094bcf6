// @ts-check
/** The PNG is the project: what it carries, what it never carries, and the ways back in. */

import { withoutMetadata } from '../../../../www/engine/metadata/strip.ts';
import { SECRETS, loaded } from '../../../../www/engine/metadata/testing.ts';
import { openExport, saved } from '../export-hands.js';
import { panel } from '../panel-hands.js';
import { accessible, add, drop, expect, idle, openBoard, photos, picture, press, SIX, tab, test } from '../support.js';
import { word, write } from '../word-hands.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const STYLE = {
  id: 'dropped',
  name: 'Dropped',
  tags: ['ink'],
  background: [{ block: 'posterize', levels: 4 }],
  foreground: [{ block: 'to_gray' }, { block: 'xdog' }],
  ink: '#203050',
};
const PLAIN = ['IHDR', 'pHYs', 'sRGB', 'IDAT', 'IEND'];

/** Photos as a telephone makes them, turned and told. @param {...string} names */
async function told(...names) {
  return Promise.all(
    (await photos(...names)).map(async (file) => ({
      ...file,
      buffer: Buffer.from(await loaded(new Blob([new Uint8Array(file.buffer)])).arrayBuffer()),
    })),
  );
}

/** A page with everything that is a person's own. @param {Page} page */
async function ownPage(page) {
  await page.goto('./');
  await add(page, [...(await told(...SIX.slice(0, 3))), ...(await photos(...SIX.slice(3)))]);
  await idle(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('6');
  await press(page, 'Surprise layout');
  await drop(page, [
    { name: 'dropped.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(STYLE)) },
  ]);
  await page.getByRole('region', { name: 'Style designer' }).getByRole('button', { name: 'Use', exact: true }).click();
  await idle(page);
  await panel(page, 1).focus();
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('+');
  await idle(page);
  await write(page, 'balloon', 'AS IT WAS');
}

const download = async (/** @type {Page} */ page) =>
  (await saved(page, () => page.getByRole('button', { name: 'Download PNG' }).click())).bytes;

/** @param {Page} page @param {string} cargo @returns {Promise<Buffer>} */
async function exported(page, cargo) {
  const dialog = await openExport(page);
  await dialog.getByRole('radio', { name: cargo }).check();
  return (await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click())).bytes;
}

/** @param {Buffer} png @returns {string[]} the types of its chunks, each kind once */
function chunksOf(png) {
  /** @type {string[]} */
  const types = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) types.push(png.toString('latin1', at + 4, at + 8));
  return types.filter((type, i) => type !== types[i - 1]);
}

/** The same picture, and then the same file. @param {Buffer} made @param {Buffer} png */
function expectSame(made, png) {
  expect(made.subarray(made.indexOf('IDAT')).equals(png.subarray(png.indexOf('IDAT'))), 'the pixels').toBe(true);
  expect(made.equals(png), 'the file').toBe(true);
}

/** @param {Buffer} bytes */
function expectNoSecrets(bytes) {
  for (const secret of [...SECRETS, ...SIX]) expect(bytes.includes(Buffer.from(secret, 'latin1')), secret).toBe(false);
}

const file = (/** @type {string} */ name, /** @type {Buffer} */ buffer) => ({ name, mimeType: 'image/png', buffer });

/**
 * The page on a device that has seen none of it.
 * @param {import('../../../../www/testing.ts').Browser} browser
 * @param {string | undefined} baseURL
 */
async function elsewhere(browser, baseURL) {
  const context = await browser.newContext({ baseURL, viewport: { width: 1280, height: 800 }, acceptDownloads: true });
  const page = await context.newPage();
  await page.addInitScript(() => localStorage.setItem('inkpanel.detect', 'off'));
  await page.goto('./');
  return page;
}

test('a page with photos opens on another device, and goes out again byte by byte as it came', async ({
  page,
  browser,
  baseURL,
}) => {
  await ownPage(page);
  const png = await exported(page, 'With photos');
  expect(chunksOf(png)).toEqual(['IHDR', 'pHYs', 'sRGB', 'iTXt', 'IDAT', 'ipPh', 'IEND']);
  expectNoSecrets(png);
  const other = await elsewhere(browser, baseURL);
  await drop(other, [file('page.png', png)]);
  await expect(other.getByRole('status').getByText('page.png is open again')).toBeVisible();
  await idle(other);
  await expect(word(other, 'Balloon: AS IT WAS')).toBeVisible();
  // To the last byte: the pixels, and all that the file carries.
  expectSame(await exported(other, 'With photos'), png);
  // Photos go with the file for which they were asked only.
  expect(chunksOf(await download(other))).not.toContain('ipPh');
  await other.context().close();
});

test('a page without photos waits for them, and is then the same picture', async ({ page, browser, baseURL }) => {
  await ownPage(page);
  const png = await download(page);
  expect(chunksOf(png)).toEqual(['IHDR', 'pHYs', 'sRGB', 'iTXt', 'IDAT', 'IEND']);
  expectNoSecrets(png);
  const other = await elsewhere(browser, baseURL);
  await add(other, [file('page.png', png)]);
  const alert = other.getByRole('alert');
  await expect(alert.getByText('page.png is open, but its 6 photos are not on this device.')).toBeVisible();
  await idle(other);
  await expect(other.getByRole('group', { name: /^Panel \d/ }).first()).toHaveAttribute(
    'aria-description',
    /Missing photo/,
  );
  await accessible(other);
  const [chooser] = await Promise.all([
    other.waitForEvent('filechooser'),
    alert.getByRole('button', { name: 'Choose photos' }).click(),
  ]);
  await chooser.setFiles([...(await told(...SIX.slice(1, 3))), ...(await photos(...SIX.slice(3)))]);
  await expect(other.getByRole('alert').getByText('1 photo of this page is still missing')).toBeVisible();
  await expect(other.locator('.save-state')).toHaveText('Saved');
  await other.reload();
  await idle(other);
  await expect(other.getByRole('checkbox', { name: /^Use Missing photo/ })).toHaveCount(1);
  // With what the telephone wrote or without: it is the same photo.
  const [{ name, mimeType, buffer }] = await told(SIX[0]);
  const { blob } = await withoutMetadata(new Blob([new Uint8Array(buffer)]));
  await drop(other, [{ name, mimeType, buffer: Buffer.from(await blob.arrayBuffer()) }]);
  await expect(other.getByRole('status').getByText('1 photo is back in place.')).toBeVisible();
  await expect(other.getByRole('alert')).toHaveText('');
  await idle(other);
  expectSame(await download(other), png);
  await other.context().close();
});

test('a page opens beside the work that is there, and there is a way back', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 4));
  const png = await download(page);
  await page.getByLabel('Project name').fill('First');
  await page.keyboard.press('Enter');
  await press(page, 'Shuffle');
  const before = await picture(page);
  await drop(page, [file('page.png', png)]);
  const note = page.getByRole('status').getByText('page.png is open again').locator('..');
  await expect(note).toBeVisible();
  await idle(page);
  await expect(page.getByLabel('Project name')).toHaveValue(/\d{4}$/);
  await note.getByRole('button', { name: 'Back to First' }).click();
  await expect(page.getByLabel('Project name')).toHaveValue('First');
  await idle(page);
  expect(await picture(page)).toBe(before);
  await drop(page, [file('again.png', png)]);
  await page.getByRole('status').getByRole('button', { name: 'Use as a photo' }).click();
  await expect(page.getByRole('checkbox', { name: 'Use again.png' })).toBeVisible();
  await expect(page.getByLabel('Project name')).toHaveValue('First');
});

test('a page that is damaged or too new is named, and can still be a photo', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  const png = await download(page);
  const before = await picture(page);
  const spoilt = Buffer.from(png);
  spoilt[spoilt.indexOf('iTXtinkpanel') + 40] ^= 0x55;
  await drop(page, [file('spoilt.png', spoilt)]);
  const alert = page.getByRole('alert').filter({ hasText: 'spoilt.png could not be opened: it is damaged' });
  await expect(alert).toBeVisible();
  expect(await picture(page)).toBe(before);
  await alert.getByRole('button', { name: 'Use as a photo' }).click();
  await expect(page.getByRole('checkbox', { name: 'Use spoilt.png' })).toBeVisible();
});

test('without project data the PNG is the picture and nothing else', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await accessible(page);
  await page.keyboard.press('Escape');
  const png = await exported(page, 'Without project data');
  expect(chunksOf(png)).toEqual(PLAIN);
  // It stays so until something else is chosen.
  expect((await download(page)).equals(png)).toBe(true);
  const whole = await exported(page, 'With project data');
  await page.getByRole('button', { name: 'Projects' }).click();
  await page.getByLabel('Project file').setInputFiles([file('plain.png', png)]);
  await expect(
    page.getByRole('alert').getByText('plain.png could not be opened: it is a picture without project data.'),
  ).toBeVisible();
  await page.getByLabel('Project file').setInputFiles([file('page.png', whole)]);
  await expect(page.getByRole('status').getByText('page.png is open again')).toBeVisible();
});

test('a project file has the photos, but not where and when they were taken', async ({ page }) => {
  await page.goto('./');
  await add(page, await told(...SIX.slice(0, 3)));
  await idle(page);
  const before = await picture(page);
  await page.getByLabel('Project name').fill('Back home');
  await page.getByRole('button', { name: 'Projects' }).click();
  const project = (await saved(page, () => page.getByRole('button', { name: 'Save project' }).click())).bytes;
  for (const secret of SECRETS) expect(project.includes(Buffer.from(secret, 'latin1')), secret).toBe(false);
  await expect(page.getByRole('status').getByText('without their place, date and camera')).toBeVisible();
  await page.getByRole('button', { name: 'New project' }).click();
  await drop(page, [{ name: 'back.inkpanel', mimeType: 'application/zip', buffer: project }]);
  await expect(page.getByLabel('Project name')).toHaveValue('Back home');
  await idle(page);
  expect(await picture(page)).toBe(before);
});
