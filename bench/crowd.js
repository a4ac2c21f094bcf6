// @ts-check
/**
 * A large album: time to its first page and to the end of the import, long tasks meanwhile, and the memory of the tab.
 */

import { readFileSync } from 'node:fs';
import { CHOOSING } from './journey.js';

/** @typedef {import('playwright-core').Browser} Browser */

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ photos: number, first: number, read: number, longest: number, long: number, memory: number | null }>}
 *   milliseconds from choosing the files: `first` to the first page, `read` to the end of the import. Until then, `longest`:
 *   the longest task of the main thread, `long`: number of tasks longer than 50 ms, `memory`: peak memory of the tab's process
 *   in bytes, only on Linux.
 */
export async function crowd(browser, address, photos) {
  const page = await browser.newPage({ viewport: { width: 1920, height: 1080 }, serviceWorkers: 'block' });
  await page.addInitScript(() => {
    const tasks = /** @type {number[]} */ ([]);
    Object.assign(globalThis, { tasks });
    new PerformanceObserver((list) => tasks.push(...list.getEntries().map(({ duration }) => duration))).observe({
      entryTypes: ['longtask'],
    });
  });
  await page.goto(address);
  // The app prepares for the photos while the user chooses them.
  const [dialog] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Choose photos or a video' }).click(),
  ]);
  await page.evaluate(() => {
    document.addEventListener(
      'change',
      () => {
        /** @type {any} */ (globalThis).tasks.length = 0;
        Object.assign(globalThis, { begun: performance.now() });
      },
      { capture: true, once: true },
    );
  });
  /** Milliseconds until the body has this flag. @param {'drawn' | 'idle'} flag */
  const since = async (flag) => {
    const handle = await page.waitForFunction(
      (name) => {
        const { begun } = /** @type {any} */ (globalThis);
        return document.body.dataset[name] === 'true' && performance.now() - begun;
      },
      flag,
      { polling: 50, timeout: 300_000 },
    );
    return /** @type {number} */ (await handle.jsonValue());
  };
  await page.waitForTimeout(CHOOSING);
  await dialog.setFiles(photos);
  // The page leaves its idle state with the first photo.
  await page.waitForFunction(() => document.body.dataset.idle !== 'true');
  const first = await since('drawn');
  const read = await since('idle');
  const tasks = /** @type {number[]} */ (await page.evaluate(() => /** @type {any} */ (globalThis).tasks));
  const memory = await peak(browser);
  await page.close();
  return { photos: photos.length, first, read, longest: Math.max(0, ...tasks), long: tasks.length, memory };
}

/**
 * The most memory that any of the browser's tabs had: its workers are threads of the same process.
 * @param {Browser} browser
 * @returns {Promise<number | null>} bytes; null if the system does not report them
 */
async function peak(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const tabs = processInfo
    .filter(({ type }) => type === 'renderer')
    .map(({ id }) => {
      try {
        return Number(/^VmHWM:\s+(\d+) kB/m.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1] ?? 0) * 1024;
      } catch {
        return 0;
      }
    });
  return Math.max(0, ...tabs) || null;
}
