// @ts-check
/** Files of the comic page: formats, sizes, clipboard, sharing, progress and Cancel. */

import { chooseFormat, download, openExport, saved, savedAs } from '../export-dialog.js';
import { panel } from '../panels.js';
import {
  PNG,
  accessible,
  colours,
  expect,
  makePageSmall,
  openBoard,
  press,
  reach,
  test as plainTest,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** The size of an image file, as the browser decodes it. @param {Page} page @param {Buffer} bytes @param {string} type */
function sizeOf(page, bytes, type) {
  return page.evaluate(
    async ([base64, kind]) => {
      const blob = new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], { type: kind });
      const { width, height } = await createImageBitmap(blob);
      return [width, height];
    },
    [bytes.toString('base64'), type],
  );
}

/** The size and a digest of the pixels, as the browser decodes them. @param {Page} page @param {Buffer} bytes @param {string} type */
function pixelsOf(page, bytes, type) {
  return page.evaluate(
    async ([base64, kind]) => {
      const blob = new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], { type: kind });
      const bitmap = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const hash = await crypto.subtle.digest('SHA-256', data);
      return `${canvas.width} x ${canvas.height}: ${new Uint8Array(hash).join(' ')}`;
    },
    [bytes.toString('base64'), type],
  );
}

test('Download PNG saves the page in print size, and another page gives another file', async ({ page }) => {
  await openBoard(page);
  // The message disappears again, perhaps before a file of this size is read.
  const message = expect(page.locator('.toast-list[role=status]')).toContainText('saved', { timeout: 150_000 });
  const print = await download(page);
  await message;
  expect(print.name).toMatch(/\d{4}\.png$/);
  const png = PNG.sync.read(print.bytes);
  expect([png.width, png.height]).toEqual([2480, 3508]);
  expect(colours(png)).toBeGreaterThan(2);
  // Dots per metre.
  const density = print.bytes.subarray(print.bytes.indexOf('pHYs') + 4);
  expect([density.readUInt32BE(0), density.readUInt32BE(4), density[8]]).toEqual([11811, 11811, 1]);

  await makePageSmall(page);
  const first = PNG.sync.read((await download(page)).bytes);
  await press(page, 'Shuffle');
  const second = PNG.sync.read((await download(page)).bytes);
  expect([first.width, first.height]).toEqual([600, 848]);
  expect([second.width, second.height]).toEqual([600, 848]);
  expect(second.data.equals(first.data)).toBe(false);
});

test('the export dialog saves a square', async ({ page }) => {
  await openBoard(page);
  const dialog = await openExport(page);
  await dialog.getByText('Page size: ').click();
  await dialog.getByRole('radio', { name: 'Square' }).check();
  await expect(dialog.locator('canvas[data-drawn=true]')).toBeVisible();
  await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
  await expect(dialog.getByText('1,200 × 1,200 pixels')).toBeVisible();
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  const png = PNG.sync.read(file.bytes);
  expect([png.width, png.height]).toEqual([1200, 1200]);
  expect(colours(png)).toBeGreaterThan(2);
  await expect(dialog).toBeHidden();
});

test('PNG, JPEG and WebP files contain their DPI, and a lower JPEG quality makes a smaller file', async ({ page }) => {
  await openBoard(page);
  const png = await savedAs(page, 'png');
  const density = png.bytes.subarray(png.bytes.indexOf('pHYs') + 4);
  // Dots per metre.
  expect([density.readUInt32BE(0), density.readUInt32BE(4), density[8]]).toEqual([5906, 5906, 1]);
  const fine = await savedAs(page, 'jpeg', { quality: 95 });
  expect(fine.name).toMatch(/\d{4}\.jpg$/);
  expect(fine.bytes.subarray(6, 11).toString('latin1')).toBe('JFIF\0');
  expect([fine.bytes[13], fine.bytes.readUInt16BE(14), fine.bytes.readUInt16BE(16)]).toEqual([1, 150, 150]);
  expect(await sizeOf(page, fine.bytes, 'image/jpeg')).toEqual([1240, 1754]);
  const poor = await savedAs(page, 'jpeg', { quality: 30 });
  expect(poor.bytes.length).toBeLessThan(fine.bytes.length * 0.8);

  const { name, bytes } = await savedAs(page, 'webp', { quality: 80 });
  expect(name).toMatch(/\.webp$/);
  expect([bytes.toString('latin1', 0, 4), bytes.toString('latin1', 8, 16)]).toEqual(['RIFF', 'WEBPVP8X']);
  expect(bytes.readUInt32LE(4)).toBe(bytes.length - 8);
  const exif = bytes.subarray(bytes.lastIndexOf('EXIF') + 8);
  expect([exif.toString('latin1', 0, 2), exif.readUInt32LE(50), exif.readUInt32LE(54)]).toEqual(['II', 150, 1]);
  expect(await sizeOf(page, bytes, 'image/webp')).toEqual([1240, 1754]);
});

test('the estimated file size is close to the size of the file', async ({ page }) => {
  await openBoard(page);
  const dialog = await openExport(page);
  for (const format of ['png', 'jpeg']) {
    await chooseFormat(dialog, format);
    const estimate = dialog.locator('.file-size[aria-busy=false]');
    await expect(estimate).toHaveText(/^about [\d.]+ [kKM]B$/);
    const [, amount, unit] = /** @type {RegExpMatchArray} */ ((await estimate.innerText()).match(/([\d.]+) ([kKM])B/));
    const about = Number(amount) * (unit === 'M' ? 1e6 : 1e3);
    const { bytes } = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
    expect(about / bytes.length, format).toBeGreaterThan(0.65);
    expect(about / bytes.length, format).toBeLessThan(1.5);
    await openExport(page);
  }
});

test('the page is copied to the clipboard', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openBoard(page);
  await makePageSmall(page);
  const dialog = await openExport(page);
  await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
  await dialog.getByRole('button', { name: 'Copy to clipboard' }).click();
  await expect(page.getByRole('status')).toContainText('copied to the clipboard', { timeout: 60_000 });
  const size = await page.evaluate(async () => {
    const [item] = await navigator.clipboard.read();
    const { width, height } = await createImageBitmap(await item.getType('image/png'));
    return [width, height];
  });
  expect(size).toEqual([300, 424]);
});

test('one panel is saved in its print size', async ({ page }) => {
  await openBoard(page);
  await panel(page, 1).click();
  const { bytes, name } = await saved(page, async () => (await reach(page, 'Save panel')).click());
  expect(name).toMatch(/ \d{4} - panel 1\.png$/);
  const box = /** @type {{ width: number, height: number }} */ (await panel(page, 1).boundingBox());
  const sheet = /** @type {{ width: number }} */ (await page.locator('.page-canvas').boundingBox());
  const { width, height } = PNG.sync.read(bytes);
  expect(Math.abs(width / 2480 - box.width / sheet.width)).toBeLessThan(0.02);
  expect(Math.abs(height / width - box.height / box.width)).toBeLessThan(0.05);
  expect(bytes.includes('pHYs')).toBe(true);
});

for (const width of [1280, 360]) {
  test(`axe finds nothing in the export dialog, ${width} pixels wide`, async ({ page }) => {
    await openBoard(page);
    await page.setViewportSize({ width, height: 780 });
    const dialog = await openExport(page);
    await chooseFormat(dialog, 'jpeg');
    await expect(dialog.locator('.file-size[aria-busy=false]')).toHaveText(/^about/);
    await accessible(page);
    const over = await dialog.evaluate((element) => element.scrollWidth - element.clientWidth);
    expect(over).toBe(0);
  });
}

plainTest('a browser without a WebP encoder saves a lossless WebP file', async ({ page }) => {
  await page.addInitScript(() => {
    const { convertToBlob } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.convertToBlob = function png() {
      return convertToBlob.call(this, { type: 'image/png' });
    };
  });
  await openBoard(page);
  await makePageSmall(page);
  const png = await savedAs(page, 'png');
  const { bytes } = await savedAs(page, 'webp');
  expect(bytes.toString('latin1', 0, 4)).toBe('RIFF');
  expect(bytes.toString('latin1', 8, 16)).toBe('WEBPVP8X');
  expect(bytes.includes('VP8L')).toBe(true);
  const exif = bytes.subarray(bytes.lastIndexOf('EXIF') + 8);
  expect([exif.readUInt32LE(50), exif.readUInt32LE(54)]).toEqual([150, 1]);
  expect(bytes.length).toBeLessThan(png.bytes.length * 1.5);
  expect(await pixelsOf(page, bytes, 'image/webp')).toEqual(await pixelsOf(page, png.bytes, 'image/png'));
  const dialog = await openExport(page);
  const quality = dialog.getByRole('slider', { name: 'Image quality' });
  await chooseFormat(dialog, 'jpeg');
  await expect(quality).toBeVisible();
  await chooseFormat(dialog, 'webp');
  await expect(quality).toHaveCount(0);
  await expect(dialog.locator('.file-size[aria-busy=false]')).toHaveText(/^about [\d.]+ [kKM]B$/);
});

plainTest('a file that takes long is shared by a second click', async ({ page }) => {
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
  await makePageSmall(page);
  const dialog = await openExport(page);
  const share = dialog.getByRole('button', { name: 'Share' });
  await chooseFormat(dialog, 'pdf');
  await expect(share).toHaveCount(0);
  await chooseFormat(dialog, 'jpeg');
  await share.click();
  await page.getByRole('button', { name: 'Share now' }).click({ timeout: 60_000 });
  const shared = await page.waitForFunction(() => /** @type {any} */ (window).shared?.[0]);
  expect(await shared.jsonValue()).toMatch(/\d{4}\.jpg image\/jpeg true$/);
});

plainTest('an export shows its progress and can be cancelled', async ({ page }) => {
  /** @type {string[]} */
  const downloads = [];
  page.on('download', (file) => downloads.push(file.suggestedFilename()));
  await openBoard(page);
  const progress = page.getByRole('progressbar', { name: /full size/ });
  // The worker that makes the file does not start before the export is cancelled.
  /** @type {() => void} */
  let start = () => {};
  const cancelled = new Promise((/** @type {(value?: any) => void} */ resolve) => (start = resolve));
  await page.route(/file-worker-[^/]*\.js$/, async (route) => {
    await cancelled;
    await route.continue();
  });
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'pdf');
  await dialog.getByRole('button', { name: 'Download' }).click();
  await expect(progress).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(progress).toHaveCount(0);
  start();
  // The app continues to work, and the next file is the only one.
  await press(page, 'Shuffle');
  await makePageSmall(page);
  const { name } = await savedAs(page, 'jpeg');
  expect(downloads).toEqual([name]);
  await expect(page.getByRole('alert')).toBeEmpty();
});
