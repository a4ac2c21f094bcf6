// @ts-check
/** What a person waits for, in the real built site: the first page, a shuffle, the file. */

import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** @typedef {import('playwright-core').Browser} Browser */

const PHOTOS = 12;
const SHUFFLES = 15;
const RESIZES = 8;

/**
 * Twelve JPEG files as a 12-megapixel camera writes them: the sample album enlarged, with grain. Kept between
 * runs.
 * @param {Browser} browser
 * @param {string} album folder
 * @param {string} folder for the result
 * @returns {Promise<string[]>} paths
 */
export async function bigPhotos(browser, album, folder) {
  mkdirSync(folder, { recursive: true });
  const names = readdirSync(album).filter((name) => name.endsWith('.jpg')).sort().slice(0, PHOTOS);
  const paths = names.map((name) => join(folder, name));
  if (paths.every((path) => existsSync(path))) return paths;
  const page = await browser.newPage();
  const { readFileSync } = await import('node:fs');
  for (const [i, name] of names.entries()) {
    const source = readFileSync(join(album, name)).toString('base64');
    writeFileSync(paths[i], Buffer.from(await page.evaluate(enlarge, source), 'base64'));
  }
  await page.close();
  return paths;
}

/** Runs in the page. @param {string} source JPEG in base64 @returns {Promise<string>} the same */
async function enlarge(source) {
  const bitmap = await createImageBitmap(await (await fetch(`data:image/jpeg;base64,${source}`)).blob());
  const [width, height] = bitmap.width >= bitmap.height ? [4000, 3000] : [3000, 4000];
  const canvas = new OffscreenCanvas(width, height);
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.imageSmoothingQuality = 'high';
  context.drawImage(bitmap, 0, 0, width, height);
  const image = context.getImageData(0, 0, width, height);
  let seed = 1;
  for (let i = 0; i < image.data.length; i += 1) {
    if (i % 4 === 3) continue;
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    image.data[i] += ((seed >>> 24) - 128) / 24;
  }
  context.putImageData(image, 0, 0);
  const blob = await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.92 });
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  return btoa(text);
}

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ firstPage: number, refined: number, shuffle: number, png: number, thumbnails: number, listed: number }>} milliseconds;
 *   `refined` from the first page until all photos are looked at
 */
export async function journey(browser, address, photos) {
  const page = await browser.newPage({ viewport: { width: 1920, height: 1080 }, acceptDownloads: true });
  await page.addInitScript(watch);
  await page.goto(address);
  const input = page.getByLabel('Photos or video');
  await input.waitFor({ state: 'attached' });
  const first = page.evaluate(() => /** @type {any} */ (globalThis).watch.afterChoosing());
  await input.setInputFiles(photos);
  const firstPage = await first;
  const refined = await page.evaluate(async () => {
    const start = performance.now();
    while (document.body.dataset.detected !== 'true') await new Promise((resolve) => requestAnimationFrame(resolve));
    return performance.now() - start;
  });
  const times = [];
  for (let i = 0; i < SHUFFLES; i += 1) {
    const shuffle = page.getByRole('button', { name: 'Shuffle', exact: true });
    times.push(await shuffle.evaluate((button) => /** @type {any} */ (globalThis).watch.afterPressing(button)));
  }
  const resizes = [];
  for (let i = 0; i < RESIZES; i += 1) {
    const size = page.getByRole('combobox', { name: 'Page size' });
    resizes.push(await size.evaluate((select, to) => /** @type {any} */ (globalThis).watch.afterChange(select, to), i % 2 ? 'a4' : 'letter'));
    await page.waitForFunction(() => document.body.dataset.idle === 'true');
  }
  const listed = await page.getByRole('listbox', { name: 'Layouts' }).getByRole('option').count();
  const start = performance.now();
  const [download] = await Promise.all([
    page.waitForEvent('download', { timeout: 120_000 }),
    page.getByRole('button', { name: 'Download PNG', exact: true }).click(),
  ]);
  await download.path();
  const png = performance.now() - start;
  await page.close();
  const median = (/** @type {number[]} */ list) => list.sort((a, b) => a - b)[list.length >> 1];
  return { firstPage, refined, shuffle: median(times), png, thumbnails: median(resizes), listed };
}

/** Runs in the page before its own scripts: clocks that end when what the user waits for has been painted. */
function watch() {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const idle = () => document.body.dataset.idle === 'true';
  const painted = async () => {
    // The frame in which the work begins, those that it takes, and the one that shows it.
    await frame();
    while (!idle()) await frame();
    await frame();
    return performance.now();
  };
  Object.assign(globalThis, {
    watch: {
      afterChoosing: async () => {
        const start = await new Promise((resolve) => {
          document.addEventListener('change', () => resolve(performance.now()), { capture: true, once: true });
        });
        return (await painted()) - start;
      },
      /**
       * Until the frame that shows what the change drew on this thread.
       * @param {HTMLSelectElement} select
       * @param {string} value
       */
      afterChange: async (select, value) => {
        const start = performance.now();
        select.value = value;
        select.dispatchEvent(new Event('change', { bubbles: true }));
        await frame();
        // Runs after the frame was painted.
        await new Promise((resolve) => setTimeout(resolve));
        return performance.now() - start;
      },
      /** @param {HTMLElement} button */
      afterPressing: async (button) => {
        const start = performance.now();
        button.click();
        return (await painted()) - start;
      },
    },
  });
}
