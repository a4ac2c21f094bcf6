// @ts-check
/** Photos of the tray: a click chooses and places a photo, its check box leaves it out. */

import { panel } from '../panels.js';
import { expect, idle, openBoard, sharedBoardTest as test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const photo = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('region', { name: 'Photos' }).getByRole('button', { name: `Choose ${name}` });

test('a click on a photo puts it into the selected panel, and its description names the panel', async ({ page }) => {
  await openBoard(page);
  await panel(page, 2).click();
  await photo(page, 'temple.jpg').click();
  await idle(page);
  await expect(panel(page, 2)).toHaveAccessibleDescription(/temple/);
  await expect(photo(page, 'temple.jpg')).toHaveAccessibleDescription(/on panel 2/);
  await expect(page.getByRole('checkbox', { name: 'Use temple.jpg' })).toBeChecked();
});

test('without a selected panel, a chosen photo goes to the next panel that is clicked, unless Escape cancels', async ({
  page,
}) => {
  await openBoard(page);
  await photo(page, 'crab.jpg').click();
  await expect(photo(page, 'crab.jpg')).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByText('Select the panel for this photo')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(photo(page, 'crab.jpg')).toHaveAttribute('aria-pressed', 'false');
  await photo(page, 'crab.jpg').focus();
  await page.keyboard.press('Enter');
  await panel(page, 1).click();
  await idle(page);
  await expect(panel(page, 1)).toHaveAccessibleDescription(/crab/);
});

test('the check box leaves a photo out, gives the reason, and offers Undo', async ({ page }) => {
  await openBoard(page);
  const tick = page.getByRole('checkbox', { name: 'Use bee.jpg' });
  await tick.click();
  await idle(page);
  await expect(tick).not.toBeChecked();
  await expect(tick).toHaveAccessibleDescription('You excluded it');
  await page.getByRole('status').getByRole('button', { name: 'Undo' }).click();
  await idle(page);
  await expect(tick).toBeChecked();
});

test('Space shuffles after a click on a lock, and changes the lock if the keyboard moved the focus there', async ({
  page,
}) => {
  await openBoard(page);
  const lock = page.getByRole('button', { name: 'Lock style' });
  const count = () => page.locator('.page-number').innerText();
  await lock.click();
  const before = await count();
  await page.keyboard.press('Space');
  await idle(page);
  await expect(lock).toHaveAttribute('aria-pressed', 'true');
  expect(await count()).not.toBe(before);
  await page.getByRole('button', { name: 'Shuffle style' }).focus();
  await page.keyboard.press('Tab');
  await page.keyboard.press('Shift+Tab');
  await page.getByRole('button', { name: 'Lock style' }).focus();
  await page.keyboard.press('Space');
  await expect(lock).toHaveAttribute('aria-pressed', 'false');
});
