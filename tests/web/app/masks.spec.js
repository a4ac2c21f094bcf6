// @ts-check
/** Figures that step out of their panels: their masks are made after all else, and a panel lets its figure out and in again. */

import { add, expect, openBoard, photos, picture, pixelsOf, detectingTest as test } from './support.js';
import { box, word, write } from './word-hands.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

const MASKED = { timeout: 120_000 };

/** @param {Page} page */
const masked = (page) => expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);

/** Chooses panel after panel until one lets its figure out. @param {Page} page */
async function breakOne(page) {
  const button = page.getByRole('button', { name: 'Break the frame' });
  const panels = page.getByRole('group', { name: /^Panel \d+ of/ });
  for (let i = 0; i < (await panels.count()); i += 1) {
    await panels.nth(i).click();
    if (await button.isDisabled()) continue;
    if ((await button.getAttribute('aria-pressed')) === 'true') return button;
    await button.click();
    if ((await button.getAttribute('aria-pressed')) === 'true') return button;
  }
  throw new Error('no figure steps out');
}

/** @param {string} a @param {string} b */
function different(a, b) {
  const [one, other] = [pixelsOf(a), pixelsOf(b)];
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4) if (Math.abs(one.data[i] - other.data[i]) > 24) count += 1;
  return count;
}

test('a figure steps out of its panel and back, and the page comes to rest each time', async ({ page }) => {
  test.setTimeout(240_000);
  /** @type {string[]} */
  const nets = [];
  page.on('request', (request) => {
    if (/subject.*onnx/.test(request.url())) nets.push(request.url());
  });
  await page.goto('./');
  await add(page, await photos('macaw.jpg', 'camera.jpg', 'dahlia.jpg', 'pika.jpg'));
  await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
  // Nothing waits for the masks.
  expect(nets).toEqual([]);
  await masked(page);
  expect(nets.length).toBeGreaterThan(0);
  const button = await breakOne(page);
  await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
  const out = await picture(page);
  await button.click();
  await expect(button).toHaveAttribute('aria-pressed', 'false');
  await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
  const back = await picture(page);
  expect(different(out, back)).toBeGreaterThan(200);
  await page.getByRole('button', { name: 'Undo' }).first().click();
  await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
  expect(different(out, await picture(page))).toBe(0);
});

test('words that are there stay where they are when the mask of their photo comes', async ({ page }) => {
  test.setTimeout(240_000);
  let release = () => {};
  const held = new Promise((resolve) => {
    release = () => resolve(undefined);
  });
  await page.route('**/*subject*.onnx', async (route) => {
    await held;
    await route.continue();
  });
  await openBoard(page, ['macaw.jpg']);
  await write(page, 'balloon', 'HELLO THERE');
  const balloon = word(page, /^Balloon: HELLO THERE/);
  const before = await box(balloon);
  release();
  await masked(page);
  expect(await box(balloon)).toEqual(before);
});

test('without the net the tool says what is missing', async ({ page }) => {
  await page.route('**/*subject*.onnx', (route) => route.fulfill({ contentType: 'text/html', body: 'not here' }));
  await openBoard(page, ['macaw.jpg', 'camera.jpg', 'dahlia.jpg']);
  await expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);
  await page.getByRole('group', { name: /^Panel 1 of/ }).click();
  const button = page.getByRole('button', { name: 'Break the frame' });
  await expect(button).toBeDisabled();
  await expect(button).toHaveAttribute('title', /[^.]: the net that finds figures is not part of this site/);
});
