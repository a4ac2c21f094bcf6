// @ts-check
/** An album of two hundred photos: when all are read, when all are looked at, and what kept the page from answering. */

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** @typedef {import('playwright-core').Browser} Browser */

const COUNT = 200;

/**
 * Two hundred JPEG files of three megapixels, parts of the sample album, no two alike. Kept between runs.
 * @param {Browser} browser
 * @param {string} album folder
 * @param {string} folder for the result
 * @returns {Promise<string[]>} paths
 */
export async function manyPhotos(browser, album, folder) {
  mkdirSync(folder, { recursive: true });
  const names = readdirSync(album).filter((name) => name.endsWith('.jpg')).sort();
  const paths = Array.from({ length: COUNT }, (_, i) => join(folder, `${String(i).padStart(3, '0')}.jpg`));
  if (paths.every((path) => existsSync(path))) return paths;
  const page = await browser.newPage();
  for (const [i, path] of paths.entries()) {
    const source = readFileSync(join(album, names[i % names.length])).toString('base64');
    writeFileSync(path, Buffer.from(await page.evaluate(part, /** @type {const} */ ([source, i])), 'base64'));
  }
  await page.close();
  return paths;
}

/** Runs in the page. @param {readonly [string, number]} of JPEG in base64, and a seed @returns {Promise<string>} the same */
async function part([source, seed]) {
  const bitmap = await createImageBitmap(await (await fetch(`data:image/jpeg;base64,${source}`)).blob());
  const random = (/** @type {number} */ n) => { const x = Math.sin(seed * 12.9898 + n * 78.233) * 43758.5453; return x - Math.floor(x); };
  const [width, height] = [2000, 1500];
  const scale = Math.max(width / bitmap.width, height / bitmap.height) * (1.1 + random(1));
  const canvas = new OffscreenCanvas(width, height);
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
  if (random(2) < 0.5) context.setTransform(-1, 0, 0, 1, width, 0);
  const [w, h] = [bitmap.width * scale, bitmap.height * scale];
  context.drawImage(bitmap, (width - w) * random(3), (height - h) * random(4), w, h);
  const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.9 })).arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  return btoa(text);
}

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ photos: number, read: number, found: number, longest: number, long: number }>}
 *   milliseconds from choosing to all photos read and the page drawn, and to all looked at; the longest task of the main
 *   thread, and how many took more than 50 ms
 */
export async function crowd(browser, address, photos) {
  const page = await browser.newPage({ viewport: { width: 1920, height: 1080 } });
  await page.addInitScript(() => {
    const tasks = /** @type {number[]} */ ([]);
    Object.assign(globalThis, { tasks });
    new PerformanceObserver((list) => tasks.push(...list.getEntries().map(({ duration }) => duration))).observe({ entryTypes: ['longtask'] });
  });
  await page.goto(address);
  const input = page.getByLabel('Photos or video');
  await input.waitFor({ state: 'attached' });
  await page.evaluate(() => {
    document.addEventListener('change', () => {
      /** @type {any} */ (globalThis).tasks.length = 0;
      Object.assign(globalThis, { begun: performance.now() });
    }, { capture: true, once: true });
  });
  /** Milliseconds until the body says so. @param {'idle' | 'detected'} flag */
  const since = async (flag) => {
    const handle = await page.waitForFunction((name) => {
      const { begun } = /** @type {any} */ (globalThis);
      return document.body.dataset[name] === 'true' && performance.now() - begun;
    }, flag, { polling: 'raf', timeout: 300_000 });
    return /** @type {number} */ (await handle.jsonValue());
  };
  await input.setInputFiles(photos);
  // The page leaves its idle state with the first photo.
  await page.waitForFunction(() => document.body.dataset.idle !== 'true');
  const read = await since('idle');
  const found = await since('detected');
  const tasks = /** @type {number[]} */ (await page.evaluate(() => /** @type {any} */ (globalThis).tasks));
  await page.close();
  return { photos: photos.length, read, found, longest: Math.max(0, ...tasks), long: tasks.length };
}
