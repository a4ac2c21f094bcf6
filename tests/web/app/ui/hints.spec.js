// @ts-check
/** The three hints of the first use: their place, and when they appear and disappear. */

import { covered } from '../../covered.js';
import { accessible, choose, expect, idle, openBoard, press, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page @param {string} text */
const hint = (page, text) => page.locator('.hint[data-placed=true]').filter({ hasText: text });

/** The controls that the hint covers, and whether it is inside of the window. @param {Page} page */
const place = async (page) => {
  const box = await page.locator('.hint').boundingBox();
  const { width, height } = /** @type {{ width: number, height: number }} */ (page.viewportSize());
  const inside = box && box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height;
  const under = await page.evaluate(() => {
    const hint = /** @type {HTMLElement} */ (document.querySelector('.hint'));
    hint.style.pointerEvents = 'auto';
    return hint.className;
  });
  const names = await page.evaluate(covered);
  await page.evaluate(() => {
    /** @type {HTMLElement} */ (document.querySelector('.hint')).style.pointerEvents = '';
  });
  return { under, inside, names };
};
const RIGHT = { under: 'hint', inside: true, names: [] };

for (const viewport of [
  { width: 1280, height: 800 },
  { width: 360, height: 740 },
  { width: 844, height: 390 },
]) {
  const touch = viewport.width < 1000;
  test.describe(`${viewport.width} by ${viewport.height}`, () => {
    test.use({ viewport, hasTouch: touch, isMobile: touch });

    test('each hint appears once, covers no control, and disappears after its action', async ({ page }) => {
      await openBoard(page);
      await expect(hint(page, 'Shuffle until you like it')).toBeVisible();
      await expect(page.locator('[aria-live=polite]').filter({ hasText: 'Shuffle until' })).toBeAttached();
      expect(await page.evaluate(() => document.activeElement?.closest('.hint'))).toBe(null);
      expect(await place(page)).toEqual(RIGHT);
      await accessible(page);
      await press(page, 'Shuffle');
      await expect(page.locator('.hint')).toHaveCount(0);

      // Nothing covers the last panel of a random layout.
      const panel = page.getByRole('group', { name: /^Panel \d+ of/ }).last();
      if (touch) await panel.tap();
      else await panel.hover();
      await expect(hint(page, 'Drag to move the picture')).toBeVisible();
      expect(await place(page)).toEqual(RIGHT);
      if (touch) await page.getByRole('button', { name: 'Zoom in' }).tap();
      else await page.mouse.wheel(0, -200);
      await idle(page);
      await expect(page.locator('.hint')).toHaveCount(0);

      await page.keyboard.press('Escape');
      await press(page, 'Shuffle');
      await expect(hint(page, 'Lock the parts that you like')).toBeVisible();
      expect(await place(page)).toEqual(RIGHT);
      await page.getByRole('button', { name: 'Lock style' }).click();
      await expect(page.locator('.hint')).toHaveCount(0);
    });
  });
}

test('the hint of a panel of full width is at the bottom of the panel', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('button', { name: 'Close the hint' }).click();
  await choose(page, 'inset', 'Two insets');
  await page.setViewportSize({ width: 844, height: 390 });
  await idle(page);
  await page.getByRole('group', { name: /^Panel 1 of/ }).click({ position: { x: 20, y: 150 } });
  await expect(hint(page, 'Drag to move the picture')).toBeVisible();
  expect(await place(page)).toEqual(RIGHT);
});

test('a closed hint does not appear again, until the help shows the hints again', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  await page.getByRole('button', { name: 'Close the hint' }).click();
  await expect(page.locator('.hint')).toHaveCount(0);
  await page.reload();
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await press(page, 'Shuffle');
  await press(page, 'Shuffle');
  await expect(hint(page, 'Lock the parts')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.locator('.hint')).toHaveCount(0);
  await page.keyboard.press('?');
  await page.getByRole('button', { name: 'Show the hints again' }).click();
  await expect(hint(page, 'Shuffle until you like it')).toBeVisible();
});
