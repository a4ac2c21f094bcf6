// @ts-check
/** Steps of the tests of the style designer and the style explorer. */

import { expect, openBoard } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {'Background layer' | 'Foreground layer'} LayerName */

export const FOUR = ['bee.jpg', 'cat.jpg', 'gateway.jpg', 'macaw.jpg'];

/** @param {Page} page */
export const region = (page) => page.getByRole('region', { name: 'Style designer' });

/** @param {Page} page @param {string} name */
export const button = (page, name) => region(page).getByRole('button', { name, exact: true });

/** @param {Page} page @param {LayerName} [layer] */
export const cards = (page, layer = 'Background layer') =>
  region(page).getByRole('list', { name: layer }).getByRole('listitem');

/** The standard names of the blocks of a layer, in order. @param {Page} page @param {LayerName} [layer] */
export async function names(page, layer) {
  const headings = await cards(page, layer).getByRole('heading').allTextContents();
  return headings.map((name) => name.replace(/^.* \((.*)\)$/, '$1'));
}

/** Opens the designer with a style without blocks. @param {Page} page */
export async function openDesigner(page) {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  await startEmpty(page);
}

/** Replaces the style of the page, which the designer opens with, by a style without blocks. @param {Page} page */
export async function startEmpty(page) {
  await region(page).getByRole('combobox', { name: 'Start from' }).selectOption({ label: 'An empty style' });
  await drawn(page);
}

/** Waits until the preview and the pictures of the cards are drawn. @param {Page} page */
export async function drawn(page) {
  await expect(page.getByRole('region', { name: 'Preview', exact: true })).toHaveAttribute('aria-busy', 'false');
}

/** @param {Page} page @param {string} block @param {LayerName} [layer] */
export async function addBlock(page, block, layer = 'Background layer') {
  // On a large screen the palette stays open.
  const opener = page.getByRole('button', { name: 'Add block' });
  if ((await opener.getAttribute('aria-expanded')) !== 'true') await opener.click();
  await page
    .getByRole('button', { name: layer === 'Background layer' ? 'Add to colours' : 'Add to lines', exact: true })
    .click();
  await page.getByRole('searchbox', { name: 'Search blocks' }).fill(block);
  await page.getByRole('region', { name: 'Blocks to add' }).getByRole('listitem').getByRole('button').first().click();
  await drawn(page);
}

/** The pixels of the preview. @param {Page} page */
export async function preview(page) {
  await drawn(page);
  return region(page)
    .locator('.comparison-styled')
    .first()
    .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
}

/** Opens the explorer with four photos and generates styles from a fixed seed on a fixed photo. @param {Page} page */
export async function invent(page) {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
  // Detection may change the photo of all thumbnails.
  await page.getByRole('button', { name: 'Draw the gallery on macaw.jpg' }).click();
  await page.locator('.dial-more summary').click();
  const seed = page.getByRole('spinbutton', { name: 'Seed' });
  await seed.fill('4');
  await seed.press('Enter');
  await page.getByRole('button', { name: 'Generate' }).click();
}
