// @ts-check
/** PNG files with project data: their chunks, private data, and opening them as projects. */

import { withoutMetadata } from '../../../../www/engine/metadata/strip.ts';
import { SECRETS, loaded } from '../../../../www/engine/metadata/testing.ts';
import { download as downloaded, openExport, saved } from '../export-dialog.js';
import { panel } from '../panels.js';
import {
  SIX,
  accessible,
  add,
  drop,
  expect,
  idle,
  makePageSmall,
  openBoard,
  photos,
  picture,
  press,
  tab,
  sharedBoardTest as test,
} from '../support.js';
import { word, write } from '../text-items.js';

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

/** Photos with the metadata of a phone: rotated, with date and place. @param {...string} names */
async function withMetadata(...names) {
  return Promise.all(
    (await photos(...names)).map(async (file) => ({
      ...file,
      buffer: Buffer.from(await loaded(new Blob([new Uint8Array(file.buffer)])).arrayBuffer()),
    })),
  );
}

/** Makes a comic page with a custom layout, style, crop and text. @param {Page} page */
async function ownPage(page) {
  const files = [...(await withMetadata(...SIX.slice(0, 3))), ...(await photos(...SIX.slice(3)))];
  await openBoard(page, ['photos with metadata'], files);
  await makePageSmall(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('6');
  await press(page, 'New layout');
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

const download = async (/** @type {Page} */ page) => (await downloaded(page)).bytes;

/** @param {Page} page @param {string} cargo @returns {Promise<Buffer>} */
async function exported(page, cargo) {
  const dialog = await openExport(page);
  await dialog.getByRole('radio', { name: cargo }).check();
  return (await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click())).bytes;
}

/** @param {Buffer} png @returns {string[]} the types of its chunks, without adjacent repetitions */
function chunksOf(png) {
  /** @type {string[]} */
  const types = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) types.push(png.toString('latin1', at + 4, at + 8));
  return types.filter((type, i) => type !== types[i - 1]);
}

/** Checks that two files have the same pixels, and the same bytes. @param {Buffer} made @param {Buffer} png */
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
 * Opens the app in another browser context.
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

test('a PNG file with photos opens in another browser, and is exported with the same bytes', async ({
  page,
  browser,
  baseURL,
}) => {
  await ownPage(page);
  const png = await exported(page, 'Editing again anywhere, with your photos');
  expect(chunksOf(png)).toEqual(['IHDR', 'pHYs', 'sRGB', 'iTXt', 'IDAT', 'ipPh', 'IEND']);
  expectNoSecrets(png);
  const other = await elsewhere(browser, baseURL);
  await drop(other, [file('page.png', png)]);
  await expect(other.getByRole('status').getByText('page.png was opened as a separate project')).toBeVisible();
  await idle(other);
  await expect(word(other, 'Balloon: AS IT WAS')).toBeVisible();
  expectSame(await exported(other, 'Editing again anywhere, with your photos'), png);
  // Other files do not contain the photos.
  expect(chunksOf(await download(other))).not.toContain('ipPh');
  await other.context().close();
});

test('a PNG file without photos asks for them, and is then exported with the same bytes', async ({
  page,
  browser,
  baseURL,
}) => {
  await ownPage(page);
  const png = await exported(page, 'Editing again on this device');
  expect(chunksOf(png)).toEqual(['IHDR', 'pHYs', 'sRGB', 'iTXt', 'IDAT', 'IEND']);
  expectNoSecrets(png);
  const other = await elsewhere(browser, baseURL);
  // Without its photos, the file is a picture.
  await add(other, [file('page.png', png)]);
  await expect(other.getByRole('checkbox', { name: 'Use page.png' })).toBeVisible();
  await other.getByRole('status').getByRole('button', { name: 'Open as a project' }).click();
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
  await chooser.setFiles([...(await withMetadata(...SIX.slice(1, 3))), ...(await photos(...SIX.slice(3)))]);
  await expect(other.getByRole('alert').getByText('1 photo of this page is still missing')).toBeVisible();
  await expect(other.locator('.save-state')).toHaveText('Saved');
  await other.reload();
  await idle(other);
  await expect(other.getByRole('checkbox', { name: /^Use Missing photo/ })).toHaveCount(1);
  // The metadata of a photo does not matter.
  const [{ name, mimeType, buffer }] = await withMetadata(SIX[0]);
  const { blob } = await withoutMetadata(new Blob([new Uint8Array(buffer)]));
  await drop(other, [{ name, mimeType, buffer: Buffer.from(await blob.arrayBuffer()) }]);
  await expect(other.getByRole('status').getByText('1 photo was restored.')).toBeVisible();
  await expect(other.getByRole('alert')).toHaveText('');
  await idle(other);
  expectSame(await exported(other, 'Editing again on this device'), png);
  await other.context().close();
});

test('a PNG file opens as a new project, and a button returns to the old project', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 4));
  await makePageSmall(page);
  const png = await exported(page, 'Editing again on this device');
  await page.getByLabel('Project name').fill('First');
  await page.keyboard.press('Enter');
  await press(page, 'Shuffle');
  const before = await picture(page);
  await drop(page, [file('page.png', png)]);
  const note = page.getByRole('status').getByText('page.png was opened as a separate project').locator('..');
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

test('a damaged PNG file is reported, and can be used as a photo', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  await makePageSmall(page);
  const png = await exported(page, 'Editing again on this device');
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

test('a PNG file contains no project unless the user asks for it', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  await makePageSmall(page);
  expect(chunksOf(await exported(page, 'Editing again on this device'))).toContain('iTXt');
  // The wish applies to that file only.
  expect(chunksOf(await download(page))).toEqual(PLAIN);
});

test('a PNG file without project data contains only the picture', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  await makePageSmall(page);
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await accessible(page);
  await page.keyboard.press('Escape');
  const png = await exported(page, 'Viewing only');
  expect(chunksOf(png)).toEqual(PLAIN);
  expect((await download(page)).equals(png)).toBe(true);
  const whole = await exported(page, 'Editing again on this device');
  await page.getByRole('button', { name: 'Projects' }).click();
  await page.getByLabel('Project file').setInputFiles([file('plain.png', png)]);
  await expect(
    page.getByRole('alert').getByText('plain.png could not be opened: it is an image without project data.'),
  ).toBeVisible();
  await page.getByLabel('Project file').setInputFiles([file('page.png', whole)]);
  await expect(page.getByRole('status').getByText('page.png was opened as a separate project')).toBeVisible();
});

test('a project file contains the original photos, or photos without location and camera data', async ({ page }) => {
  const originals = await withMetadata(...SIX.slice(0, 3));
  await openBoard(page, ['three photos with metadata'], originals);
  const before = await picture(page);
  await page.getByLabel('Project name').fill('Back home');
  await page.getByRole('button', { name: 'Projects' }).click();
  const save = async () => (await saved(page, () => page.getByRole('button', { name: 'Save project' }).click())).bytes;
  const whole = await save();
  for (const { name, buffer } of originals) expect(whole.includes(buffer), name).toBe(true);
  await expect(page.getByRole('status').getByText('with your original photos')).toBeVisible();

  const clean = page.getByLabel('Remove location and camera data');
  await clean.check();
  const project = await save();
  for (const secret of SECRETS) expect(project.includes(Buffer.from(secret, 'latin1')), secret).toBe(false);
  await expect(page.getByRole('status').getByText('without their place, date and camera')).toBeVisible();

  for (const [i, buffer] of [whole, project].entries()) {
    await page.getByRole('button', { name: 'New project' }).click();
    await drop(page, [{ name: `back-${i}.inkpanel`, mimeType: 'application/zip', buffer }]);
    await expect(page.getByLabel('Project name')).toHaveValue('Back home');
    await idle(page);
    expect(await picture(page)).toBe(before);
    await page.getByRole('button', { name: 'Projects' }).click();
    await expect(clean).toBeChecked();
  }
});
