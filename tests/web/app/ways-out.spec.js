// @ts-check
import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { promisify } from 'node:util';
import { PNG } from '../../../www/testing.js';
import { accessible, expect, idle, openBoard, press, test } from './support.js';
import { panel } from './panel-hands.js';
import { write } from './word-hands.js';

/** @typedef {import('../../../www/testing.js').Page} Page */

const run = promisify(execFile);

/** @param {Page} page */
async function openExport(page) {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  return page.getByRole('dialog', { name: 'Export the page' });
}

/**
 * @param {Page} page
 * @param {() => Promise<void>} act
 * @returns {Promise<{ name: string, path: string, bytes: Buffer }>}
 */
async function saved(page, act) {
  const waiting = page.waitForEvent('download', { timeout: 90_000 });
  await act();
  const download = await waiting;
  const path = await download.path();
  return { name: download.suggestedFilename(), path, bytes: await readFile(path) };
}

/**
 * Saves the page as a kind of file.
 * @param {Page} page
 * @param {string} format
 * @param {{ quality?: number, half?: boolean }} [how]
 */
async function savedAs(page, format, { quality, half = true } = {}) {
  const dialog = await openExport(page);
  if (half) await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption(format);
  if (quality !== undefined) await dialog.getByRole('slider', { name: 'Picture quality' }).fill(String(quality));
  return saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
}

/** What the browser makes of a picture. @param {Page} page @param {Buffer} bytes @param {string} type */
function sizeOf(page, bytes, type) {
  return page.evaluate(async ([base64, kind]) => {
    const blob = new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], { type: kind });
    const { width, height } = await createImageBitmap(blob);
    return [width, height];
  }, [bytes.toString('base64'), type]);
}

test('PNG and JPEG say their dots an inch, and a lower quality makes a smaller file', async ({ page }) => {
  await openBoard(page);
  const png = await savedAs(page, 'png');
  const about = png.bytes.subarray(png.bytes.indexOf('pHYs') + 4);
  // Dots a metre.
  expect([about.readUInt32BE(0), about.readUInt32BE(4), about[8]]).toEqual([5906, 5906, 1]);
  const fine = await savedAs(page, 'jpeg', { quality: 95 });
  expect(fine.name).toMatch(/^inkpanel-.*\.jpg$/);
  expect(fine.bytes.subarray(6, 11).toString('latin1')).toBe('JFIF\0');
  expect([fine.bytes[13], fine.bytes.readUInt16BE(14), fine.bytes.readUInt16BE(16)]).toEqual([1, 150, 150]);
  expect(await sizeOf(page, fine.bytes, 'image/jpeg')).toEqual([1240, 1754]);
  const poor = await savedAs(page, 'jpeg', { quality: 30 });
  expect(poor.bytes.length).toBeLessThan(fine.bytes.length * 0.8);
});

test('WebP says its dots an inch', async ({ page }) => {
  await openBoard(page);
  const { name, bytes } = await savedAs(page, 'webp', { quality: 80 });
  expect(name).toMatch(/\.webp$/);
  expect([bytes.toString('latin1', 0, 4), bytes.toString('latin1', 8, 16)]).toEqual(['RIFF', 'WEBPVP8X']);
  expect(bytes.readUInt32LE(4)).toBe(bytes.length - 8);
  const exif = bytes.subarray(bytes.lastIndexOf('EXIF') + 8);
  expect([exif.toString('latin1', 0, 2), exif.readUInt32LE(50), exif.readUInt32LE(54)]).toEqual(['II', 150, 1]);
  expect(await sizeOf(page, bytes, 'image/webp')).toEqual([1240, 1754]);
});

test('a PDF has the page in its size, text that is found, and looks as the PNG does', async ({ page }, info) => {
  await openBoard(page);
  await write(page, 'caption', 'Meanwhile, at the harbour');
  await write(page, 'balloon', 'Où est le phare?');
  await write(page, 'sound effect', 'KRAKOOM');
  const arc = page.getByRole('spinbutton', { name: 'Arc' });
  await arc.fill('80');
  await arc.blur();
  await idle(page);
  await page.keyboard.press('Escape');
  const { path, name } = await savedAs(page, 'pdf', { quality: 95 });
  expect(name).toMatch(/\.pdf$/);
  const about = (await run('pdfinfo', [path])).stdout;
  expect(about).toMatch(/Pages: +1\n/);
  expect(about).toMatch(/Page size: +595\.2 x 841\.9\d* pts \(A4\)/);
  expect(about).not.toContain('CreationDate');
  const text = (await run('pdftotext', ['-raw', path, '-'])).stdout.replace(/\s+/g, ' ');
  for (const words of ['Meanwhile, at the harbour', 'Où est le phare?']) {
    expect(text).toContain(words);
  }
  expect(text.replace(/ /g, '')).toContain('KRAKOOM');
  const fonts = (await run('pdffonts', [path])).stdout.trim().split('\n').slice(2);
  expect(fonts).toHaveLength(3);
  for (const line of fonts) expect(line).toMatch(/CID TrueType +Identity-H +yes yes yes/);
  await run('pdftoppm', ['-png', '-r', '150', '-singlefile', path, info.outputPath('drawn')]);
  const drawn = PNG.sync.read(await readFile(info.outputPath('drawn.png')));
  const png = await savedAs(page, 'png');
  await writeFile(info.outputPath('page.png'), png.bytes);
  const expected = PNG.sync.read(png.bytes);
  expect([drawn.width, drawn.height]).toEqual([expected.width, expected.height]);
  const { mean, far } = difference(drawn, expected);
  expect(mean).toBeLessThan(4);
  expect(far).toBeLessThan(0.01);
});

/**
 * Squares are compared, as programs that draw PDF files put pixels a fraction further.
 * @param {PNG} a
 * @param {PNG} b
 * @returns {{ mean: number, far: number }} the mean difference of their channels, of 255; the share of those that are far off
 */
function difference(a, b) {
  const side = 10;
  let [sum, count, far] = [0, 0, 0];
  for (let y = 0; y + side <= a.height; y += side) {
    for (let x = 0; x + side <= a.width; x += side) {
      for (let channel = 0; channel < 3; channel += 1) {
        let off = 0;
        for (let i = 0; i < side * side; i += 1) {
          const at = ((y + Math.floor(i / side)) * a.width + x + (i % side)) * 4 + channel;
          off += a.data[at] - b.data[at];
        }
        const mean = Math.abs(off) / side ** 2;
        sum += mean;
        count += 1;
        if (mean > 30) far += 1;
      }
    }
  }
  return { mean: sum / count, far: far / count };
}

test('the size that is told before is about the size of the file', async ({ page }) => {
  await openBoard(page);
  const dialog = await openExport(page);
  for (const format of ['png', 'jpeg']) {
    await dialog.getByRole('combobox', { name: 'Format' }).selectOption(format);
    const told = dialog.locator('.file-size[aria-busy=false]');
    await expect(told).toHaveText(/^about [\d.]+ [KM]B$/);
    const [, amount, unit] = /** @type {RegExpMatchArray} */ ((await told.innerText()).match(/([\d.]+) ([KM])B/));
    const about = Number(amount) * (unit === 'M' ? 1e6 : 1e3);
    const { bytes } = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
    expect(about / bytes.length, format).toBeGreaterThan(0.5);
    expect(about / bytes.length, format).toBeLessThan(2);
    await openExport(page);
  }
});

test('the page is copied to the clipboard', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openBoard(page);
  const dialog = await openExport(page);
  await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  await dialog.getByRole('button', { name: 'Copy to clipboard' }).click();
  await expect(page.getByRole('status')).toContainText('on the clipboard', { timeout: 60_000 });
  const size = await page.evaluate(async () => {
    const [item] = await navigator.clipboard.read();
    const { width, height } = await createImageBitmap(await item.getType('image/png'));
    return [width, height];
  });
  expect(size).toEqual([1240, 1754]);
});

test('a file that took long is shared with a second click', async ({ page }) => {
  await page.addInitScript(() => {
    /** @type {string[]} */
    const shared = [];
    const answers = [new DOMException('', 'NotAllowedError'), null];
    Object.assign(navigator, {
      canShare: (/** @type {{ files: File[] }} */ { files }) => files[0].type !== 'application/pdf',
      share: async (/** @type {{ files: File[] }} */ { files }) => {
        const refused = answers.shift();
        if (refused) throw refused;
        shared.push(`${files[0].name} ${files[0].type} ${files[0].size > 1000}`);
        Object.assign(window, { shared });
      },
    });
  });
  await openBoard(page);
  const dialog = await openExport(page);
  const share = dialog.getByRole('button', { name: 'Share' });
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('pdf');
  await expect(share).toHaveCount(0);
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('jpeg');
  await share.click();
  await page.getByRole('button', { name: 'Share now' }).click({ timeout: 60_000 });
  const shared = await page.waitForFunction(() => /** @type {any} */ (window).shared?.[0]);
  expect(await shared.jsonValue()).toMatch(/^inkpanel-.*\.jpg image\/jpeg true$/);
});

test('one panel is saved at its print size', async ({ page }) => {
  await openBoard(page);
  await panel(page, 1).click();
  const { bytes, name } = await saved(page, () => page.getByRole('button', { name: 'Save this panel' }).click());
  expect(name).toMatch(/-panel-1\.png$/);
  const box = /** @type {{ width: number, height: number }} */ (await panel(page, 1).boundingBox());
  const sheet = /** @type {{ width: number }} */ (await page.locator('.page-canvas').boundingBox());
  const { width, height } = PNG.sync.read(bytes);
  expect(Math.abs(width / 2480 - box.width / sheet.width)).toBeLessThan(0.02);
  expect(Math.abs(height / width - box.height / box.width)).toBeLessThan(0.05);
  expect(bytes.includes('pHYs')).toBe(true);
});

test('making a PDF shows its progress and can be cancelled', async ({ page }) => {
  await openBoard(page);
  let downloads = 0;
  page.on('download', () => { downloads += 1; });
  const dialog = await openExport(page);
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('pdf');
  await dialog.getByRole('button', { name: 'Save the file' }).click();
  await expect(page.getByRole('progressbar', { name: /full size/ })).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByRole('progressbar', { name: /full size/ })).toHaveCount(0);
  await page.waitForTimeout(1500);
  expect(downloads).toBe(0);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('all pages go into one PDF, and into one archive', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('3');
  await idle(page);
  const add = page.getByRole('button', { name: 'Add page' });
  test.skip(await add.count() === 0, 'there is one page only');
  await press(page, 'Add page');
  const dialog = await openExport(page);
  await dialog.getByRole('radio', { name: 'All 2 pages' }).check();
  await expect(dialog.getByRole('radio', { name: 'Square' })).toHaveCount(0);
  await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  const pdf = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  expect(pdf.name).toBe('inkpanel-2-pages.pdf');
  expect((await run('pdfinfo', [pdf.path])).stdout).toMatch(/Pages: +2\n/);
  expect((await run('pdfimages', ['-list', pdf.path])).stdout.match(/ jpeg /g)?.length).toBe(6);
  await openExport(page);
  await dialog.getByRole('radio', { name: 'All 2 pages' }).check();
  await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('cbz');
  await dialog.getByRole('combobox', { name: 'Pictures in it' }).selectOption('jpeg');
  const cbz = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  expect(cbz.name).toBe('inkpanel-2-pages.cbz');
  expect(cbz.bytes.toString('latin1').match(/page-\d\d\.jpg/g)).toEqual(['page-01.jpg', 'page-02.jpg', 'page-01.jpg', 'page-02.jpg']);
});

for (const width of [1280, 360]) {
  test(`the dialog is for everybody at ${width} pixels`, async ({ page }) => {
    await openBoard(page);
    await page.setViewportSize({ width, height: 780 });
    const dialog = await openExport(page);
    await dialog.getByRole('combobox', { name: 'Format' }).selectOption('jpeg');
    await expect(dialog.locator('.file-size[aria-busy=false]')).toHaveText(/^about/);
    await accessible(page);
    const over = await dialog.evaluate((element) => element.scrollWidth - element.clientWidth);
    expect(over).toBe(0);
  });
}
