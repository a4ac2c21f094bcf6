// @ts-check
/** Photos as a camera writes them, made from the sample album: enlarged, with grain. */

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/**
 * Writes `count` different 12-megapixel JPEG files: the photos of the album, then mirrored parts of them, with EXIF thumbnails. The files are
 * reused by later runs.
 * @param {import('playwright-core').Browser} browser
 * @param {string} album folder
 * @param {string} folder for the result
 * @param {number} count
 * @returns {Promise<string[]>} paths
 */
export async function makePhotos(browser, album, folder, count) {
  mkdirSync(folder, { recursive: true });
  const names = readdirSync(album)
    .filter((name) => name.endsWith('.jpg'))
    .sort();
  const paths = Array.from({ length: count }, (_, i) => join(folder, `${String(i).padStart(3, '0')}.jpg`));
  const page = await browser.newPage();
  for (const [i, path] of paths.entries()) {
    if (existsSync(path)) continue;
    const source = readFileSync(join(album, names[i % names.length])).toString('base64');
    const made = await page.evaluate(enlarge, /** @type {const} */ ([source, i < names.length ? 0 : i]));
    writeFileSync(path, Buffer.from(made, 'base64'));
  }
  await page.close();
  return paths;
}

/**
 * Runs in the page.
 * @param {readonly [string, number]} of JPEG in base64, and a seed for the part; 0 for the whole photo
 * @returns {Promise<string>} JPEG in base64
 */
async function enlarge([source, part]) {
  const bitmap = await createImageBitmap(await (await fetch(`data:image/jpeg;base64,${source}`)).blob());
  const [width, height] = bitmap.width >= bitmap.height ? [4000, 3000] : [3000, 4000];
  const canvas = new OffscreenCanvas(width, height);
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.imageSmoothingQuality = 'high';
  const random = (/** @type {number} */ n) => {
    const x = Math.sin(part * 12.9898 + n * 78.233) * 43758.5453;
    return x - Math.floor(x);
  };
  if (part > 0 && random(2) < 0.5) context.setTransform(-1, 0, 0, 1, width, 0);
  const zoom = part > 0 ? 1.1 + random(1) : 1;
  context.drawImage(
    bitmap,
    width * (1 - zoom) * random(3),
    height * (1 - zoom) * random(4),
    width * zoom,
    height * zoom,
  );
  const image = context.getImageData(0, 0, width, height);
  let seed = 1;
  for (let i = 0; i < image.data.length; i += 1) {
    if (i % 4 === 3) continue;
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    image.data[i] += ((seed >>> 24) - 128) / 24;
  }
  context.putImageData(image, 0, 0);
  const blob = await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.92 });
  // Cameras store a thumbnail in the metadata.
  const little = new OffscreenCanvas(160, 120);
  little.getContext('2d')?.drawImage(canvas, 0, 0, 160, 120);
  const thumbnail = await little.convertToBlob({ type: 'image/jpeg', quality: 0.7 });
  const exif = new DataView(new ArrayBuffer(58));
  exif.setUint16(0, 0xffe1);
  exif.setUint16(2, 56 + thumbnail.size);
  exif.setUint32(4, 0x45786966);
  // The header of TIFF, an empty directory, and a directory with the position of the thumbnail.
  exif.setUint32(10, 0x4d4d002a);
  exif.setUint32(14, 8);
  exif.setUint32(20, 14);
  exif.setUint16(24, 2);
  for (const [at, tag, value] of [
    [26, 0x0201, 48],
    [38, 0x0202, thumbnail.size],
  ]) {
    exif.setUint16(at, tag);
    exif.setUint16(at + 2, 4);
    exif.setUint32(at + 4, 1);
    exif.setUint32(at + 8, value);
  }
  const file = new Blob([blob.slice(0, 2), exif, thumbnail, blob.slice(2)]);
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  return btoa(text);
}
