// @ts-check
/** The menu: help, theme and language. */

import { covered } from '../../covered.js';
import {
  accessible,
  expect,
  idle,
  openBoard,
  openStart,
  test as plainTest,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const background = (/** @type {Page} */ page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
const LIGHT = 'rgb(250, 250, 251)';
const DARK = 'rgb(23, 23, 27)';

/** @param {Page} page */
const menu = (page) => page.getByRole('dialog', { name: 'Menu' });

/** @param {Page} page @param {string} name */
async function choose(page, name) {
  await page.getByRole('button', { name: 'Menu' }).click();
  await menu(page).getByRole('radio', { name, exact: true }).check();
}

test('the theme follows the system until the user chooses one, also after a reload', async ({ page }) => {
  await openStart(page);
  await page.emulateMedia({ colorScheme: 'light' });
  await idle(page);
  expect(await background(page)).toBe(LIGHT);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await background(page)).toBe(DARK);
  await choose(page, 'Light');
  expect(await background(page)).toBe(LIGHT);
  await page.reload();
  await idle(page);
  expect(await background(page)).toBe(LIGHT);
  await choose(page, 'System');
  expect(await background(page)).toBe(DARK);
  await page.reload();
  await idle(page);
  expect(await background(page)).toBe(DARK);
});

for (const [chosen, system, colour] of /** @type {const} */ ([
  ['dark', 'light', DARK],
  ['light', 'dark', LIGHT],
])) {
  plainTest(`the ${chosen} theme applies before the scripts of the app are loaded`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: system });
    await page.addInitScript((theme) => localStorage.setItem('inkpanel.theme', theme), chosen);
    await page.route('**/assets/*.js', () => {});
    await page.goto('./', { waitUntil: 'commit' });
    await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => /css$/.test(name)));
    await page.waitForFunction(() => document.styleSheets.length > 0 && document.body);
    expect(await page.evaluate(() => document.querySelector('.start-words')?.childElementCount)).toBe(0);
    expect(await background(page)).toBe(colour);
    await page.unrouteAll();
  });
}

plainTest('the theme can be changed without storage', async ({ page }) => {
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

test('keyboard: the menu is opened and left, and a click next to it closes it', async ({ page }) => {
  await openBoard(page);
  const button = page.getByRole('button', { name: 'Menu' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(menu(page).getByRole('button', { name: 'Help and keyboard shortcuts' })).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(menu(page).getByRole('radio', { name: 'System' })).toBeFocused();
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
  await choose(page, 'System');
});

test('on a small screen, the menu has the views and the page settings, too', async ({ page }) => {
  await openBoard(page);
  await page.setViewportSize({ width: 360, height: 740 });
  await page.getByRole('button', { name: 'Menu' }).click();
  for (const name of ['Page settings', 'Comic', 'Storyboard', 'Style designer', 'Explore styles'])
    await expect(menu(page).getByRole('button', { name })).toBeVisible();
  await page.getByRole('radio', { name: 'Dark' }).check();
  expect(await background(page)).toBe(DARK);
  await expect(page.getByRole('combobox', { name: 'Language' })).toBeVisible();
  await page.getByRole('radio', { name: 'System' }).check();
  await menu(page).getByRole('button', { name: 'Page settings' }).click();
  await expect(menu(page)).toHaveCount(0);
  await expect(page.getByRole('region', { name: 'Page settings' })).toBeVisible();
});

test('the menu fits on the start screen of a small screen', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await openStart(page);
  await idle(page);
  await page.getByRole('button', { name: 'Menu' }).click();
  await menu(page).getByRole('combobox', { name: 'Language' }).scrollIntoViewIfNeeded();
  const box = await menu(page).boundingBox();
  expect(box && box.x >= 0 && box.x + box.width <= 320).toBe(true);
  expect((await page.evaluate(covered)).filter((name) => /Light|Dark|Language/.test(name))).toEqual([]);
});
