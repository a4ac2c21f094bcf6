// @ts-check
/** Language and theme: one menu, what it chooses, and when. */

import { covered } from '../../covered.js';
import { accessible, expect, idle, openBoard, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const background = (/** @type {Page} */ page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
const LIGHT = 'rgb(250, 250, 251)';
const DARK = 'rgb(23, 23, 27)';

/** @param {Page} page */
const menu = (page) => page.getByRole('dialog', { name: 'Language and theme' });

/** @param {Page} page @param {string} name */
async function choose(page, name) {
  await page.getByRole('button', { name: 'Language and theme' }).click();
  await menu(page).getByRole('radio', { name, exact: true }).check();
}

test('the theme is that of the system, as it changes, until one is chosen, which is kept', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await page.goto('./');
  await idle(page);
  expect(await background(page)).toBe(LIGHT);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await background(page)).toBe(DARK);
  await choose(page, 'Light');
  expect(await background(page)).toBe(LIGHT);
  await page.reload();
  await idle(page);
  expect(await background(page)).toBe(LIGHT);
  await choose(page, 'As the system');
  expect(await background(page)).toBe(DARK);
  await page.reload();
  await idle(page);
  expect(await background(page)).toBe(DARK);
});

for (const [chosen, system, colour] of /** @type {const} */ ([
  ['dark', 'light', DARK],
  ['light', 'dark', LIGHT],
])) {
  test(`a page that is chosen to be ${chosen} is so before its program has come`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: system });
    await page.addInitScript((theme) => localStorage.setItem('inkpanel.theme', theme), chosen);
    await page.route('**/assets/*.js', () => {});
    await page.goto('./', { waitUntil: 'commit' });
    await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => /css$/.test(name)));
    await page.waitForFunction(() => document.styleSheets.length > 0 && document.body);
    expect(await page.evaluate(() => document.getElementById('app')?.childElementCount)).toBe(0);
    expect(await background(page)).toBe(colour);
    await page.unrouteAll();
  });
}

test('the theme is chosen where nothing can be kept', async ({ page }) => {
  await page.addInitScript(() => {
    for (const name of /** @type {const} */ (['getItem', 'setItem', 'removeItem']))
      Storage.prototype[name] = () => {
        throw new DOMException('refused', 'SecurityError');
      };
  });
  await page.goto('./');
  await idle(page);
  await choose(page, 'Dark');
  expect(await background(page)).toBe(DARK);
});

test('the menu is opened and left by keys, and by a press beside it', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  const button = page.getByRole('button', { name: 'Language and theme' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(menu(page).getByRole('radio', { name: 'As the system' })).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
  await accessible(page);
  await page.keyboard.press('Tab');
  await expect(menu(page).getByRole('combobox', { name: 'Language' })).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(menu(page)).toHaveCount(0);
  await expect(button).toBeFocused();
  await button.click();
  await page.mouse.click(400, 400);
  await expect(menu(page)).toHaveCount(0);
});

test('on a small screen the choices are among the settings of the page', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await openBoard(page, ['cat.jpg']);
  await page.getByRole('button', { name: 'Page settings' }).click();
  await page.getByRole('radio', { name: 'Dark' }).check();
  expect(await background(page)).toBe(DARK);
  await expect(page.getByRole('combobox', { name: 'Language' })).toBeVisible();
});

test('on the start of a small screen the menu is within it', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.goto('./');
  await idle(page);
  await page.getByRole('button', { name: 'Language and theme' }).click();
  await menu(page).getByRole('combobox', { name: 'Language' }).scrollIntoViewIfNeeded();
  const box = await menu(page).boundingBox();
  expect(box && box.x >= 0 && box.x + box.width <= 320).toBe(true);
  expect((await page.evaluate(covered)).filter((name) => /Light|Dark|Language/.test(name))).toEqual([]);
});
