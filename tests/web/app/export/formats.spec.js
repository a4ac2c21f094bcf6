// @ts-check
import { PNG } from '../../../../www/testing.ts';
import { openExport, saved, savedAs } from '../export-hands.js';
import { panel } from '../panel-hands.js';
import { accessible, expect, openBoard, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** What the browser makes of a picture. @param {Page} page @param {Buffer} bytes @param {string} type */
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

/** The size and the pixels that the browser sees. @param {Page} page @param {Buffer} bytes @param {string} type */
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

test('PNG and JPEG say their dots an inch, and a lower quality makes a smaller file', async ({ page }) => {
  await openBoard(page);
  const png = await savedAs(page, 'png');
  const about = png.bytes.subarray(png.bytes.indexOf('pHYs') + 4);
  // Dots a metre.
  expect([about.readUInt32BE(0), about.readUInt32BE(4), about[8]]).toEqual([5906, 5906, 1]);
  const fine = await savedAs(page, 'jpeg', { quality: 95 });
  expect(fine.name).toMatch(/\d{4}\.jpg$/);
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

test('a browser without an encoder of WebP saves one without loss', async ({ page }) => {
  await page.addInitScript(() => {
    const { convertToBlob } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.convertToBlob = function png() {
      return convertToBlob.call(this, { type: 'image/png' });
    };
  });
  await openBoard(page);
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
  const quality = dialog.getByRole('slider', { name: 'Picture quality' });
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('jpeg');
  await expect(quality).toBeVisible();
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('webp');
  await expect(quality).toHaveCount(0);
  await expect(dialog.locator('.file-size[aria-busy=false]')).toHaveText(/^about [\d.]+ [KM]B$/);
});

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
    expect(about / bytes.length, format).toBeGreaterThan(0.65);
    expect(about / bytes.length, format).toBeLessThan(1.5);
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
  expect(await shared.jsonValue()).toMatch(/\d{4}\.jpg image\/jpeg true$/);
});

test('one panel is saved at its print size', async ({ page }) => {
  await openBoard(page);
  await panel(page, 1).click();
  const { bytes, name } = await saved(page, () => page.getByRole('button', { name: 'Save this panel' }).click());
  expect(name).toMatch(/ \d{4} - panel 1\.png$/);
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
  page.on('download', () => {
    downloads += 1;
  });
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
