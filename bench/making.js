// @ts-check
/**
 * Measures custom styles in the real app: updates of the designer's preview while a slider moves, and generated styles
 * per second in the explorer. Also the time of a search for a style like a picture.
 */

import { opened } from './opened.js';

/** @typedef {import('playwright-core').Browser} Browser */

/** A chain of three blocks, because XDoG adds a threshold. The slider changes the first block, so all three run for every picture. */
const CHAIN = ['Gaussian Smoothing', 'XDoG'];
const DRAG_MS = 3000;
/** Minimum time that a user needs in the browser's file dialog. */
const DIALOG_MS = 4000;

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @param {string[]} pictures paths of pictures for the style search
 * @returns {Promise<{ frames: number, width: number, height: number, styles: number, searches: number[], hasty: number }>} pictures per
 *   second, their size, styles per second, milliseconds of each search, and of a search that starts when the workspace opens
 */
export async function making(browser, address, photos, pictures) {
  const page = await opened(browser, address, photos);
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  // The designer opens with the style of the page.
  await page.getByRole('combobox', { name: 'Start from' }).selectOption('An empty style');
  // The same photo every time, whatever the page shows.
  await page.getByRole('group', { name: 'Preview on' }).getByRole('button', { name: 'Photo' }).click();
  await page.getByRole('group', { name: 'Preview photo' }).getByRole('button').first().click();
  for (const block of CHAIN) {
    // On a large screen the palette stays open.
    const opener = page.getByRole('button', { name: 'Add block' });
    if ((await opener.getAttribute('aria-expanded')) !== 'true') await opener.click();
    await page.getByRole('searchbox', { name: 'Search blocks' }).fill(block);
    await page.getByRole('region', { name: 'Blocks to add' }).getByRole('listitem').getByRole('button').first().click();
  }
  const slider = page.getByRole('list', { name: 'Background layer' }).getByRole('slider').first();
  await slider.evaluate(drag, 1000);
  const dragged = await slider.evaluate(drag, DRAG_MS);
  await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
  const generate = page.getByRole('button', { name: 'Generate' });
  await generate.evaluate(round);
  const styles = await generate.evaluate(round);
  await page.close();
  const searches = [];
  for (const picture of pictures) searches.push(await search(browser, address, photos, picture, DIALOG_MS));
  const hasty = await search(browser, address, photos, pictures[0], 0);
  return { ...dragged, styles, searches, hasty };
}

/**
 * @param {Browser} browser
 * @param {string} address
 * @param {string[]} photos
 * @param {string} picture
 * @param {number} dialog milliseconds between opening the workspace and the arrival of the picture
 * @returns {Promise<number>} milliseconds from the picture to all proposals
 */
async function search(browser, address, photos, picture, dialog) {
  const page = await opened(browser, address, photos);
  await page.getByRole('button', { name: 'Style from a picture', exact: true }).click();
  const region = page.getByRole('region', { name: 'Style from a picture' });
  await region.evaluate(watch);
  await page.waitForTimeout(dialog);
  await region.getByLabel('Picture with the style that you want').setInputFiles(picture);
  await page.waitForFunction(() => 'ended' in document.body.dataset, undefined, { timeout: 120_000 });
  const { begun, ended } = await page.evaluate(() => ({ ...document.body.dataset }));
  await page.close();
  return Number(ended) - Number(begun);
}

/** Runs in the page: notes on its body when the picture is chosen and when all styles are found. @param {Element} region */
function watch(region) {
  const times = document.body.dataset;
  region.addEventListener('change', () => (times.begun ??= String(performance.now())), true);
  const observer = new MutationObserver(() => {
    const found = region.querySelector('[aria-label="Styles found"] [aria-pressed]') !== null;
    if (!found || region.getAttribute('aria-busy') === 'true') return;
    times.ended = String(performance.now());
    observer.disconnect();
  });
  observer.observe(region, { attributes: true, childList: true, subtree: true });
}

/** Runs in the page: moves a slider with every frame, and counts the pictures that follow. @param {Element} element @param {number} ms */
async function drag(element, ms) {
  const slider = /** @type {HTMLInputElement} */ (element);
  const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('.comparison-styled'));
  const pictures = () => Number(canvas.dataset.pictures);
  const [start, before] = [performance.now(), pictures()];
  for (let i = 0; performance.now() - start < ms; i += 1) {
    slider.value = String(1 + (i % 60) / 10);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }
  const frames = (pictures() - before) / ((performance.now() - start) / 1000);
  slider.dispatchEvent(new Event('change', { bubbles: true }));
  return { frames, width: canvas.width, height: canvas.height };
}

/** Runs in the page: one round of the explorer. Returns the styles tried per second. */
async function round() {
  const button = /** @type {HTMLButtonElement} */ (
    [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Generate')
  );
  const region = /** @type {Element} */ (document.querySelector('.explorer'));
  const start = performance.now();
  button.click();
  let total = 0;
  do {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    total = document.querySelector('progress')?.max ?? total;
  } while (region.getAttribute('aria-busy') === 'true');
  return total / ((performance.now() - start) / 1000);
}
