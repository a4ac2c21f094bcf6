// @ts-check
/** Measures the masks and borders of a page at print size, in the slowest layout. */

import init, { BenchPage, layouts } from '/pkg/inkpanel.js';

const WIDTH = 2480;
const PAGE = { width: WIDTH, height: 3508 };
const RUNS = 9;
/** Layouts that are timed with care, out of all that were timed once. */
const SLOWEST = 5;

/** @returns {Promise<{ layout: string, ms: number }>} the median of the slowest layout */
export async function masks() {
  await init();
  const list = JSON.parse(layouts()).map((/** @type {{ id: string, count: number }} */ { id, count }) => {
    const panels = Array.from({ length: count }, () => ({}));
    const document = { version: 1, seed: 0, layout: id, style: 'comic', panels, page: PAGE };
    return { layout: id, page: new BenchPage(JSON.stringify(document), WIDTH), ms: 0 };
  });
  for (const entry of list) entry.ms = Math.min(time(entry.page), time(entry.page));
  const slowest = list.sort((/** @type {any} */ a, /** @type {any} */ b) => b.ms - a.ms).slice(0, SLOWEST);
  for (const entry of slowest) {
    const times = Array.from({ length: RUNS }, () => time(entry.page)).sort((a, b) => a - b);
    entry.ms = times[RUNS >> 1];
  }
  const { layout, ms } = slowest.sort((/** @type {any} */ a, /** @type {any} */ b) => b.ms - a.ms)[0];
  for (const { page } of list) page.free();
  return { layout, ms };
}

/** @param {BenchPage} page */
function time(page) {
  const start = performance.now();
  page.draw_masks();
  return performance.now() - start;
}
