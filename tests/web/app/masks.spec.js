// @ts-check
/** Figures that step out of their panels: their masks are made after all else, and a panel lets its figure out and in again. */

import { savedAs } from './export-hands.js';
import { saved } from './project-hands.js';
import { add, choose, different, expect, idle, openBoard, photos, picture, detectingTest as test } from './support.js';
import { box, inked, openWords, word, write } from './word-hands.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

const MASKED = { timeout: 120_000 };

/** @param {Page} page */
const masked = (page) => expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);

/** Chooses panel after panel until one lets its figure out. @param {Page} page */
async function breakOne(page) {
  const button = page.getByRole('button', { name: 'Break out of panel' });
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

/** The page as a file. @param {Page} page @returns {Promise<string>} a data address of a PNG */
async function exported(page) {
  const { bytes } = await savedAs(page, 'png');
  await page.keyboard.press('Escape');
  return `data:image/png;base64,${bytes.toString('base64')}`;
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
  // No panel of it lies over another, where a click would meet it.
  await choose(page, 'grid', 'Four');
  await masked(page);
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

test('an effect stands behind the figure of its panel, on the page and in the file, until it is undone', async ({
  page,
}) => {
  test.setTimeout(240_000);
  await openBoard(page, ['macaw.jpg']);
  await write(page, 'sound effect', 'KRAAAK');
  const behind = page.getByLabel('Behind the subject', { exact: true });
  // Nobody knows yet where the figure is.
  await masked(page);
  await expect(behind).not.toBeChecked();
  for (const [label, value] of [
    ['Width', '90'],
    ['X', '50'],
    ['Y', '38'],
  ]) {
    await page.getByLabel(label, { exact: true }).fill(value);
    await page.getByLabel(label, { exact: true }).blur();
  }
  await idle(page);
  const before = await inked(page);
  const file = await exported(page);
  await openWords(page);
  await behind.check();
  await idle(page);
  const cut = await inked(page);
  // Some of it is behind the bird, some beside it.
  expect(cut.count).toBeLessThan(before.count * 0.9);
  expect(cut.count).toBeGreaterThan(before.count * 0.1);
  expect(different(file, await exported(page))).toBeGreaterThan(1000);
  await openWords(page);
  await page.getByRole('button', { name: 'Undo' }).first().click();
  await idle(page);
  await expect(behind).not.toBeChecked();
  expect((await inked(page)).count).toBe(before.count);
  await page.getByRole('button', { name: 'Redo' }).first().click();
  await saved(page);
  await page.reload();
  await idle(page);
  expect((await inked(page)).count).toBe(cut.count);
});

test('without the net the tool says what is missing', async ({ page }) => {
  await page.route('**/*subject*.onnx', (route) => route.fulfill({ contentType: 'text/html', body: 'not here' }));
  await openBoard(page, ['macaw.jpg', 'camera.jpg', 'dahlia.jpg']);
  await expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);
  await page.getByRole('group', { name: /^Panel 1 of/ }).click();
  const button = page.getByRole('button', { name: 'Break out of panel' });
  await expect(button).toBeDisabled();
  await expect(button).toHaveAttribute('title', /[^.]: this site was built without subject detection/);
});
