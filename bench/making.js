// @ts-check
/** Styles in the making, in the real page: how often the designer's preview follows a slider, and how fast the explorer invents. */

import { opened } from './opened.js';

/** @typedef {import('playwright-core').Browser} Browser */

/** A chain of three blocks, the first of which is moved: all three are drawn anew for every picture. */
const CHAIN = ['Gaussian Smoothing', 'XDoG', 'Soft Threshold'];
const DRAG_MS = 3000;

/**
 * @param {Browser} browser
 * @param {string} address of the site
 * @param {string[]} photos paths
 * @returns {Promise<{ frames: number, width: number, height: number, styles: number }>} pictures a second, their size, and styles a second
 */
export async function making(browser, address, photos) {
  const page = await opened(browser, address, photos);
  await page.getByRole('button', { name: 'Designer', exact: true }).click();
  // The same photo every time, whatever the page shows.
  await page.getByRole('group', { name: 'Preview on' }).getByRole('button', { name: 'Photo' }).click();
  await page.getByRole('group', { name: 'Photo of the preview' }).getByRole('button').first().click();
  for (const block of CHAIN) {
    await page.getByRole('button', { name: 'Add block' }).click();
    await page.getByRole('searchbox').fill(block);
    await page.getByRole('region', { name: 'Blocks to add' }).getByRole('listitem').getByRole('button').first().click();
  }
  const slider = page.getByRole('list', { name: 'Background layer' }).getByRole('slider').first();
  await slider.evaluate(drag, 1000);
  const dragged = await slider.evaluate(drag, DRAG_MS);
  await page.getByRole('button', { name: 'Explorer', exact: true }).click();
  const generate = page.getByRole('button', { name: 'Generate' });
  await generate.evaluate(round);
  const styles = await generate.evaluate(round);
  await page.close();
  return { ...dragged, styles };
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

/** Runs in the page: one round of the explorer; gives the styles tried a second. */
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
