// @ts-check
/** The help: search, keyboard and accessibility. */

import { accessible, expect, idle, openBoard, openStart, sharedBoardTest as test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page */
const help = (page) => page.getByRole('dialog', { name: 'Help and keyboard shortcuts' });

/** Opens the help of the start screen. @param {Page} page */
async function open(page) {
  await openStart(page);
  await idle(page);
  await page.getByRole('button', { name: 'Menu' }).click();
  await page.getByRole('button', { name: 'Help and keyboard shortcuts' }).click();
  return { dialog: help(page), search: help(page).getByRole('searchbox', { name: 'Search help' }) };
}

for (const [width, colorScheme] of /** @type {const} */ ([
  [1280, 'light'],
  [360, 'dark'],
])) {
  test(`topics and shortcuts are found by a word, ${width} pixels wide, in ${colorScheme} colours`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height: 740 });
    await page.emulateMedia({ colorScheme });
    const { dialog, search } = await open(page);
    await expect(search).toBeFocused();
    expect(await dialog.locator('summary').count()).toBeGreaterThan(15);
    await expect(dialog.getByText('Drop photos or videos anywhere')).toBeHidden();
    await dialog.getByText('Adding photos and videos').click();
    await expect(dialog.getByText('Drop photos or videos anywhere')).toBeVisible();
    await accessible(page);
    await search.fill('BALLÓON');
    await expect(dialog.getByText('you add a caption, a balloon')).toBeVisible();
    await expect(dialog.locator('summary')).toHaveCount(1);
    await expect(dialog.getByRole('status')).toHaveText('Found: 1 topic, 0 shortcuts');
    await search.fill('undo');
    await expect(dialog.getByRole('term').filter({ hasText: 'Ctrl' })).toBeVisible();
    await accessible(page);
    await search.fill('zzz');
    await expect(dialog.getByRole('status')).toContainText('Nothing found for “zzz”.');
    await accessible(page);
    await dialog.getByRole('button', { name: 'Show all topics' }).click();
    expect(await dialog.locator('summary').count()).toBeGreaterThan(15);
    expect(await dialog.evaluate((element) => element.scrollWidth - element.clientWidth)).toBe(0);
    // Escape closes the help, also from a field with text, and returns the focus.
    await search.fill('page');
    await search.press('Escape');
    await expect(dialog).toHaveCount(0);
    await expect(page.getByRole('button', { name: 'Menu' })).toBeFocused();
  });
}

test('shortcuts do nothing in the help', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  await page.keyboard.press('?');
  await page.keyboard.type('s l p');
  await expect(help(page).getByRole('searchbox')).toHaveValue('s l p');
  await page.keyboard.press('Escape');
  await idle(page);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });

  test('the help is in the menu, and does not open the keyboard of the phone', async ({ page }) => {
    await openBoard(page, ['cat.jpg']);
    await page.getByRole('button', { name: 'Menu' }).tap();
    await page.getByRole('button', { name: 'Help and keyboard shortcuts' }).tap();
    await expect(help(page)).toBeVisible();
    await expect(help(page).getByRole('searchbox')).not.toBeFocused();
  });
});
