// @ts-check
/** Images that both the browser and the core decode are similar: a mean difference of at most 2 of 255. */

import { readFileSync, readdirSync } from 'node:fs';
import { PNG, expect, test } from '../../../www/testing.ts';
import { openCore } from './core.js';

/** The object that `openCore` stored in the page. @type {any} */
let core;

const DATA = new URL('../../oracles/data/', import.meta.url);
const PHOTOS = new URL('../../photos/', import.meta.url);
const MOST = 2;
/** Under alpha, Chromium's AVIF decoder and the one of Pillow part a little further. */
const MOST_CLEAR = 3;
/** Formats without a decoder in Chromium. */
const ONLY_OURS = /\.tiff?$/;
/**
 * Features that Chromium ignores: unusual curves, the EXIF orientation of a WebP file, and LUT-based CMYK profiles.
 * `tests/import.rs` compares these files with littlecms.
 */
const NOT_THEIRS = /^(png-icc-formulas\.png|webp-exif-6\.webp|jpeg-icc-tables-(press|ycck)\.jpg)$/;

/** @param {URL} folder @param {RegExp} [wanted] */
const files = (folder, wanted = /\.(jpg|png|gif|webp|bmp|avif)$/) =>
  readdirSync(folder)
    .filter((name) => wanted.test(name))
    .sort()
    .map((name) => ({ name, base64: readFileSync(new URL(name, folder)).toString('base64') }));

test.beforeEach(async ({ page }) => openCore(page));

test('every format is seen as the browser sees it', async ({ page }) => {
  const all = [...files(new URL('files/', DATA), /./), ...files(PHOTOS)];
  const both = all.filter(({ name }) => !ONLY_OURS.test(name) && !NOT_THEIRS.test(name));
  expect(both.length).toBeGreaterThan(60);
  for (const { name, base64 } of both) {
    const { ours, theirs, apart } = await page.evaluate(compared, base64);
    expect.soft(ours, name).toEqual(theirs);
    expect.soft(apart, name).toBeLessThanOrEqual(MOST);
  }
});

test('what only the browser decodes comes as Pillow sees it, with its date', async ({ page }) => {
  const photos = files(new URL('foreign/', DATA), /avif$/);
  expect(photos.length).toBeGreaterThan(3);
  for (const decoder of ['ImageDecoder', 'createImageBitmap']) {
    for (const { name, base64 } of photos) {
      const { meta, rgb } = await page.evaluate(foreign, /** @type {const} */ ([base64, decoder]));
      const { width, height, data } = PNG.sync.read(
        readFileSync(new URL(`foreign/${name.replace('avif', 'png')}`, DATA)),
      );
      const seen = Buffer.from(rgb, 'base64');
      expect
        .soft([meta.width, meta.height, meta.taken], `${name} by ${decoder}`)
        .toEqual([width, height, '2019:07:14 18:03:59']);
      let sum = 0;
      for (let i = 0; i < width * height; i += 1)
        for (let c = 0; c < 3; c += 1) sum += Math.abs(data[4 * i + c] - seen[c * width * height + i]);
      expect
        .soft(sum / seen.length, `${name} by ${decoder}`)
        .toBeLessThanOrEqual(name === 'clear.avif' ? MOST_CLEAR : MOST);
    }
  }
});

test('files that start like HEIC and AVIF are reported as damaged', async ({ page }) => {
  const attempt = (/** @type {string} */ head) =>
    page.evaluate(async (text) => {
      const { foreignKind, asBmp } = await import(/** @type {any} */ ('/engine/foreign.ts'));
      const bytes = new TextEncoder().encode(text.padEnd(200, 'x'));
      const kind = foreignKind(bytes);
      return (
        kind &&
        asBmp(kind, bytes).then(
          () => 'read',
          (/** @type {any} */ { code, message }) => ({ code, message }),
        )
      );
    }, head);
  expect(await attempt('\0\0\0\x18ftypheic\0\0\0\0mif1heic')).toEqual({
    code: 'damaged-photo',
    message: 'HEIC',
  });
  expect(await attempt('\0\0\0\x18ftypavif\0\0\0\0mif1avif')).toEqual({
    code: 'damaged-photo',
    message: 'AVIF',
  });
  expect(await attempt('\0\0\0\x18ftypisom\0\0\0\0mp42mp41')).toBe(null);
});

/** Runs in the page. @param {string} base64 of a file */
async function compared(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const { reading } = await import(/** @type {any} */ ('/engine/readable.ts'));
  const studio = new core.Studio();
  await reading(bytes, (/** @type {Uint8Array} */ file) => studio.import_full('a', file));
  const planes = studio.photo_planes('a/full');
  const { value } = await reading(bytes, (/** @type {Uint8Array} */ file) => studio.import_photo('a', file));
  const { width: w, height: h } = JSON.parse(value).meta;
  studio.free();
  // The page itself never reads a canvas back; here it is the browser's own way that is asked for.
  const bitmap = await createImageBitmap(new Blob([bytes]));
  const { width, height } = bitmap;
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
    new OffscreenCanvas(width, height).getContext('2d')
  );
  context.fillStyle = '#fff';
  context.fillRect(0, 0, width, height);
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  let sum = 0;
  for (let i = 0; i < width * height; i += 1)
    for (let c = 0; c < 3; c += 1) sum += Math.abs(data[4 * i + c] - planes[c * width * height + i]);
  return { ours: [w, h], theirs: [width, height], apart: sum / planes.length };
}

/** Runs in the page. @param {readonly [string, string]} job a file in base64, and the decoder to take */
async function foreign([base64, decoder]) {
  const { foreignKind, asBmp } = await import(/** @type {any} */ ('/engine/foreign.ts'));
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const kept = globalThis.ImageDecoder;
  if (decoder !== 'ImageDecoder') Reflect.deleteProperty(globalThis, 'ImageDecoder');
  try {
    const file = await asBmp(foreignKind(bytes), bytes);
    const studio = new core.Studio();
    const meta = { ...JSON.parse(studio.import_photo('a', file)).meta, taken: core.taken_in_boxes(bytes) };
    studio.import_full('b', file);
    const rgb = studio.photo_planes('b/full');
    return { meta, rgb: btoa(Array.from(rgb, (/** @type {number} */ byte) => String.fromCharCode(byte)).join('')) };
  } finally {
    globalThis.ImageDecoder = kept;
  }
}
