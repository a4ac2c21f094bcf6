// @ts-check
import { choose, expect, idle, openBoard, picture, test } from '../support.js';
import { touch as fingersGo } from '../touch-hands.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, deviceScaleFactor: 2 });

const panel = (/** @type {Page} */ page, /** @type {number} */ n) =>
  page.getByRole('group', { name: new RegExp(`^Panel ${n} of`) });

/** @param {Page} page */
async function four(page) {
  await openBoard(page);
  await page.getByRole('button', { name: 'Layouts', exact: true }).click();
  await choose(page, 'grid', 'Four');
  await page.getByRole('button', { name: 'Close' }).click();
}

/** @param {Page} page @param {[number, number][][]} fingers */
async function touch(page, fingers) {
  await fingersGo(page, fingers);
  await idle(page);
}

/** @param {Page} page @param {number} n @returns {Promise<[number, number]>} */
async function middle(page, n) {
  const box = await panel(page, n).boundingBox();
  if (!box) throw new Error(`no panel ${n}`);
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** @param {Page} page */
const photos = (page) =>
  page
    .getByRole('group', { name: /^Panel \d/ })
    .evaluateAll((list) => list.map((element) => element.getAttribute('aria-description')?.split(',')[0]));

test('two fingers zoom, one pans the panel that was tapped', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  const [x, y] = await middle(page, 1);
  await touch(page, [
    [
      [x - 15, y],
      [x - 30, y],
      [x - 45, y],
      [x - 60, y],
    ],
    [
      [x + 15, y],
      [x + 30, y],
      [x + 45, y],
      [x + 60, y],
    ],
  ]);
  const near = await picture(page);
  expect(near).not.toBe(start);
  await panel(page, 1).tap();
  await idle(page);
  await touch(page, [
    [
      [x, y],
      [x + 10, y + 10],
      [x + 25, y + 30],
      [x + 30, y + 40],
    ],
  ]);
  expect(await picture(page)).not.toBe(near);
  const shown = await photos(page);
  expect(new Set(shown).size).toBe(4);
});

test('tapped, swapped, tapped: two photos change places', async ({ page }) => {
  await four(page);
  const before = await photos(page);
  await panel(page, 2).tap();
  await page.getByRole('button', { name: 'Swap photo' }).tap();
  await panel(page, 3).tap();
  await idle(page);
  expect(await photos(page)).toEqual([before[0], before[2], before[1], before[3]]);
  // And by a drag.
  await panel(page, 1).tap();
  const [from, to] = [await middle(page, 1), await middle(page, 4)];
  const half = /** @type {[number, number]} */ ([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
  await touch(page, [[from, half, to, to]]);
  expect(await photos(page)).toEqual([before[3], before[2], before[1], before[0]]);
});

test('a photo is put in a panel, and the panel locked', async ({ page }) => {
  await four(page);
  const before = await photos(page);
  await panel(page, 1).tap();
  await page.getByRole('button', { name: 'Photos', exact: true }).tap();
  const put = page.getByRole('button', { name: /^Put .* in panel 1$/ });
  const names = await put.evaluateAll((list) => list.map((button) => String(button.getAttribute('aria-label'))));
  const other = names.findIndex((name) => !before.some((photo) => name.includes(String(photo))));
  await put.nth(other).tap();
  await idle(page);
  const after = await photos(page);
  expect(names[other]).toContain(String(after[0]));
  expect(after.slice(1)).toEqual(before.slice(1));
  await page.getByRole('button', { name: 'Close' }).tap();
  await page.getByRole('button', { name: 'Lock panel' }).tap();
  await page.getByRole('button', { name: 'Shuffle', exact: true }).tap();
  await idle(page);
  expect((await photos(page))[0]).toBe(after[0]);
});
