// @ts-check
/** Styles sorted by the net, where the site was built with it; without it this file has nothing to say. */
import { existsSync } from 'node:fs';
import { invent } from './designer-hands.js';
import { accessible, detectingTest as test, expect } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

test.skip(
  !existsSync(new URL('../../../www/models/aesthetics.onnx', import.meta.url)),
  'the net is optional, and was not made',
);

/** @param {Page} page */
const region = (page) => page.getByRole('region', { name: 'Style explorer' });
/** The labels of the scores, in the order of the wall. @param {Page} page */
const labels = (page) =>
  region(page)
    .getByRole('listitem')
    .getByRole('img')
    .evaluateAll((list) => list.map((label) => String(label.getAttribute('aria-label'))));

/** Some styles on the wall, and no more coming. @param {Page} page */
async function wall(page) {
  await invent(page);
  await expect.poll(async () => (await labels(page)).length).toBeGreaterThan(10);
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
}

test('the net scores the styles in the background, and those of its choice come first', async ({ page }) => {
  /** @type {string[]} */
  const fetched = [];
  page.on('request', (request) => {
    if (request.url().includes('aesthetics')) fetched.push(request.url());
  });
  await wall(page);
  expect(fetched).toEqual([]);
  expect((await labels(page)).every((label) => label.startsWith('Light score'))).toBe(true);

  await page.getByRole('button', { name: 'Sort by score' }).click();
  await expect(page.getByRole('progressbar', { name: /Scoring styles/ })).toBeVisible();
  await expect
    .poll(async () => (await labels(page)).filter((label) => label.startsWith('NIMA score')).length, {
      timeout: 60_000,
    })
    .toBeGreaterThan(0);
  await accessible(page);
  await expect
    .poll(async () => (await labels(page)).every((label) => label.startsWith('NIMA score')), { timeout: 60_000 })
    .toBe(true);
  await expect(page.getByRole('progressbar', { name: /Scoring styles/ })).toHaveCount(0);
  const scores = (await labels(page)).map((label) => Number(/NIMA score ([\d.]+) of 10/.exec(label)?.[1]));
  expect(scores).toEqual([...scores].sort((a, b) => b - a));
  expect(new Set(scores).size).toBeGreaterThan(5);
  expect(Math.min(...scores)).toBeGreaterThan(1);
});

test('scoring can be stopped, and goes on when styles are sorted anew', async ({ page }) => {
  await wall(page);
  const sort = page.getByRole('button', { name: 'Sort by score' });
  await sort.click();
  await page.getByRole('button', { name: 'Stop scoring' }).click();
  await expect(page.getByRole('progressbar', { name: /Scoring styles/ })).toHaveCount(0);
  const before = (await labels(page)).filter((label) => label.startsWith('Light score')).length;
  expect(before).toBeGreaterThan(0);
  await sort.click();
  await sort.click();
  await expect
    .poll(async () => (await labels(page)).every((label) => label.startsWith('NIMA score')), { timeout: 60_000 })
    .toBe(true);
});
