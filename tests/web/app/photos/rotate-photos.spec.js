// @ts-check
/** Photos are rotated in the tray, with the pointer and with the keyboard. */

import { accessible, expect, idle, openBoard, picture, press, sharedBoardTest as test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page */
const tiles = (page) =>
  page.locator('.photo-picture').evaluateAll((all) => all.map((one) => one.getAttribute('aria-label')));

test('a photo is rotated in the tray without a panel, by its button and by the key R', async ({ page }) => {
  await openBoard(page);
  const before = await picture(page);
  const order = await tiles(page);
  const first = page.locator('.photo').first();
  const name = (await first.locator('.photo-name').textContent()) ?? '';
  await first.hover();
  await first.getByRole('button', { name: `Rotate ${name}` }).click();
  await expect.poll(() => picture(page)).not.toBe(before);
  await idle(page);
  expect(await tiles(page)).toEqual(order);
  await press(page, 'Undo');
  await expect.poll(() => picture(page)).toBe(before);

  // The keyboard: the focus follows the photo, so that the key can be pressed again.
  const picked = page.locator('.photo-picture').first();
  await picked.focus();
  await page.keyboard.press('r');
  await expect.poll(() => picture(page)).not.toBe(before);
  const once = await picture(page);
  await expect(page.locator('.photo-picture').first()).toBeFocused();
  await page.keyboard.press('r');
  await expect.poll(() => picture(page)).not.toBe(once);
  await idle(page);

  // A picked photo stays picked, and its button is the next stop of the keyboard after its switches.
  await page.keyboard.press('Enter');
  await expect(page.locator('.photo-picture').first()).toHaveAttribute('aria-pressed', 'true');
  const twice = await picture(page);
  const rotate = page
    .locator('.photo')
    .first()
    .getByRole('button', { name: `Rotate ${name}` });
  await rotate.focus();
  await page.keyboard.press('Enter');
  await expect.poll(() => picture(page)).not.toBe(twice);
  await expect(page.locator('.photo-picture').first()).toHaveAttribute('aria-pressed', 'true');
  await expect(rotate).toBeFocused();
  await accessible(page);
  await page.keyboard.press('Escape');
  for (let i = 0; i < 3; i += 1) await press(page, 'Undo');
  await expect.poll(() => picture(page)).toBe(before);
});
