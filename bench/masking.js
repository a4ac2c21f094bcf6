// @ts-check
/** Cost of subject masks for other work in the real app: Shuffles during detection, and the first page. */

import { median, opened, shuffled } from './journey.js';

/** @typedef {import('playwright-core').Browser} Browser */

/** Shuffles once all masks are there, and milliseconds between two. */
const SHUFFLES = 25;
/** Masks wait for shuffles, so that they would never end. */
const MOST = 60;
const PAUSE = 400;
/** First pages of either kind. */
const OPENINGS = 3;

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ count: number, during: number, after: number, first: number, bare: number }>} medians in
 * milliseconds: `during` of `count` Shuffles during detection, `after` of Shuffles after it, `first` of first pages
 * with the model, `bare` of first pages on a site without it
 */
export async function masking(browser, address, photos) {
  const { first, bare } = await firstPages(browser, address, photos);
  const { page } = await opened(browser, address, photos);
  const flag = (/** @type {'detected' | 'masked'} */ name) =>
    page.evaluate((key) => document.body.dataset[key] === 'true', name);
  await page.waitForFunction(() => document.body.dataset.detected === 'true', null, { timeout: 300_000 });
  const [during, after] = [/** @type {number[]} */ ([]), /** @type {number[]} */ ([])];
  while (during.length < MOST && !(await flag('masked'))) {
    during.push(await shuffled(page));
    await page.waitForTimeout(PAUSE);
  }
  for (let i = 0; i < SHUFFLES; i += 1) {
    after.push(await shuffled(page));
    await page.waitForTimeout(PAUSE);
  }
  await page.close();
  return { count: during.length, during: median(during), after: median(after), first, bare };
}

/**
 * Runs with and without the model, alternately. @param {Browser} browser @param {string} address @param {string[]}
 * photos
 */
async function firstPages(browser, address, photos) {
  const times = { first: /** @type {number[]} */ ([]), bare: /** @type {number[]} */ ([]) };
  for (let i = 0; i < OPENINGS; i += 1) {
    for (const kind of /** @type {const} */ (['bare', 'first'])) {
      const { page, drawn } = await opened(browser, address, photos, {
        lacks: kind === 'bare' ? /subject.*\.onnx/ : undefined,
      });
      times[kind].push(drawn);
      await page.close();
    }
  }
  return { first: median(times.first), bare: median(times.bare) };
}
