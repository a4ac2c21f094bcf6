// @ts-check
/** Styles sorted by the model, if the site was built with it. */
import { existsSync } from 'node:fs';
import { invent } from '../style-designer.js';
import { accessible, detectingTest as test, expect } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

test.skip(
  !existsSync(new URL('../../../../www/models/aesthetics.onnx', import.meta.url)),
  'the net is optional, and was not made',
);

/** @param {Page} page */
const region = (page) => page.getByRole('region', { name: 'Style explorer' });
/** The scores, in the order of the wall. @param {Page} page */
const scores = (page) =>
  region(page)
    .getByRole('listitem')
    .getByRole('img')
    .evaluateAll((list) => list.map((label) => Number(label.textContent)));
/** The styles, in the order of the wall. @param {Page} page */
const order = (page) =>
  region(page)
    .getByRole('listitem')
    .evaluateAll((list) => list.map((item) => String(item.getAttribute('data-style'))));
/** Whether the net is at work. @param {Page} page */
const judging = (page) => page.getByRole('progressbar', { name: /Scoring styles/ });

/** Some styles on the wall, and no more coming. @param {Page} page */
async function wall(page) {
  await invent(page);
  await expect.poll(async () => (await order(page)).length).toBeGreaterThan(10);
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
}

test('the net scores the styles in the background, and sorts them when all have a score', async ({ page }) => {
  /** @type {string[]} */
  const fetched = [];
  page.on('request', (request) => {
    if (request.url().includes('aesthetics')) fetched.push(request.url());
  });
  await wall(page);
  // It may be loaded by then for styles that a shuffle may draw, but nothing on the wall is scored by it.
  await expect(judging(page)).toHaveCount(0);

  const sort = page.getByRole('button', { name: 'Sort by score' });
  // There is one score: no figure is shown until the net has scored the styles.
  expect(await scores(page)).toEqual([]);
  await sort.click();
  const before = await order(page);
  await expect(judging(page)).toBeVisible();
  await accessible(page);
  await expect(judging(page)).toHaveCount(0, { timeout: 120_000 });
  expect(fetched.length).toBeGreaterThan(0);
  expect((await order(page)).toSorted()).toEqual(before.toSorted());
  const sorted = await scores(page);
  expect(sorted.length).toBe(before.length);
  expect(sorted).toEqual(sorted.toSorted((a, b) => b - a));
  expect(new Set(sorted).size).toBeGreaterThan(5);
  expect(sorted.every((score) => score >= 0 && score <= 100)).toBe(true);
  await expect(region(page)).not.toContainText('Sort again to update the order.');
});

test('scoring can be stopped, and goes on when styles are sorted again', async ({ page }) => {
  await wall(page);
  const sort = page.getByRole('button', { name: 'Sort by score' });
  await sort.click();
  await page.getByRole('button', { name: 'Stop scoring' }).click();
  await expect(judging(page)).toHaveCount(0);
  await sort.click();
  await expect(judging(page)).toBeVisible();
  await expect(judging(page)).toHaveCount(0, { timeout: 120_000 });
});
