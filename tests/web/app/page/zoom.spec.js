// @ts-check
/** Zoom of the comic page. */

import { four, panel } from '../panels.js';
import { expect, idle, press, testsOn } from '../support.js';

/** @typedef {import('../support.js').Page} Page */

const test = testsOn(four);

const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('button', { name, exact: true });

/** @param {Page} page @returns {Promise<{ width: number, height: number, x: number, y: number }>} */
const boxOf = (page) => panel(page, 1).evaluate((element) => element.getBoundingClientRect().toJSON());

/** Shows the whole page again, with no panel chosen. @param {Page} page */
async function shrink(page) {
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('x');
  await page.keyboard.press('Escape');
}

test('zooming keeps the middle of the page in place, sharpens it, and returns to the whole page', async ({ page }) => {
  const canvas = page.locator('.page-canvas');
  const painted = () => canvas.evaluate((element) => /** @type {HTMLCanvasElement} */ (element).width);
  const [whole, pixels] = [await boxOf(page), await painted()];
  await press(page, 'Enlarge page');
  await page.keyboard.press('z');
  await expect.poll(async () => (await boxOf(page)).width / whole.width).toBeCloseTo(2, 1);
  // Sharper pixels come a moment after the larger page.
  await expect.poll(painted).toBeGreaterThan(1.9 * pixels);
  await idle(page);
  // The corner where the four panels meet was in the middle, and is.
  const [stage, corner] = [
    await page.locator('.stage-area').evaluate((element) => element.getBoundingClientRect().toJSON()),
    await boxOf(page),
  ];
  expect(Math.abs(corner.x + corner.width - (stage.x + stage.width / 2))).toBeLessThan(40);
  expect(Math.abs(corner.y + corner.height - (stage.y + stage.height / 2))).toBeLessThan(40);
  await page.keyboard.press('x');
  await page.keyboard.press('x');
  await expect.poll(async () => (await boxOf(page)).width).toBeCloseTo(whole.width, 0);
  await expect(page.locator('.stage-tools')).toHaveCount(0);
});

test('the tools of a panel remain visible while the page is enlarged', async ({ page }) => {
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('z');
  await panel(page, 1).click({ position: { x: 300, y: 300 } });
  const tools = page.getByRole('toolbar', { name: 'Panel tools' }).getByRole('button');
  for (const tool of await tools.and(page.locator(':enabled')).all()) await tool.click({ trial: true });
  await page.locator('.stage-tools').getByRole('button', { name: 'Shrink page' }).click({ trial: true });
  await shrink(page);
});

test('the wheel scrolls an enlarged page and does not zoom a photo', async ({ page }) => {
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('z');
  await idle(page);
  const before = await boxOf(page);
  const area = await page.locator('.stage-area').boundingBox();
  if (!area) throw new Error('no stage');
  await page.mouse.move(area.x + area.width / 2, area.y + area.height / 2);
  await page.mouse.wheel(0, 120);
  await expect.poll(async () => before.y - (await boxOf(page)).y).toBeGreaterThan(60);
  await expect(button(page, 'Undo')).toBeEnabled();
  // Undo reverts the choice of the layout, because the wheel created no undo step.
  await button(page, 'Undo').click();
  await expect(page.getByRole('group', { name: /^Panel \d of 4$/ })).toHaveCount(0);
  await button(page, 'Redo').click();
  await idle(page);
  await shrink(page);
});
