// @ts-check
/** The pages of a comic, in the page strip. */

import { contents, idle } from './support.js';

/** @typedef {import('./support.js').Page} Page */

export const strip = (/** @type {Page} */ page) => page.getByRole('region', { name: 'Pages', exact: true });
export const thumbs = (/** @type {Page} */ page) => strip(page).getByRole('button', { name: /^Page \d+ of \d+$/ });
export const thumb = (/** @type {Page} */ page, /** @type {number} */ n) =>
  strip(page).getByRole('button', { name: new RegExp(`^Page ${n} of `) });

/** Returns the photos of each page, by opening one page after the other. @param {Page} page */
export async function photosOfPages(page) {
  const found = [];
  for (let n = 1; n <= (await thumbs(page).count()); n += 1) {
    await thumb(page, n).click();
    await idle(page);
    found.push((await contents(page)).photos);
  }
  return found;
}
