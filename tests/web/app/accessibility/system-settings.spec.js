// @ts-check
/** Accessibility settings of the system: reduced motion and forced colours. */

import { expect, idle, openBoard, test } from '../support.js';

test.describe('with reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('nothing is animated', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Shuffle', exact: true }).click();
    expect(await page.evaluate(() => document.getAnimations().length)).toBe(0);
    await idle(page);
  });
});

test.describe('with forced colours', () => {
  test.use({ contextOptions: { forcedColors: 'active' } });

  test('outlines show what is selected, pressed and focused', async ({ page }) => {
    await openBoard(page);
    const line = (/** @type {string} */ selector) =>
      page
        .locator(selector)
        .first()
        .evaluate((element) => getComputedStyle(element).outlineStyle);
    await page.getByRole('button', { name: 'Lock style' }).click();
    expect(await line('[aria-pressed=true]')).toBe('solid');
    expect(await line('.option[aria-selected=true]')).toBe('solid');
    await page.locator('.panel').first().focus();
    await page.keyboard.press('ArrowRight');
    await expect(page.locator('.panel-ring > *')).toBeVisible();
  });
});
