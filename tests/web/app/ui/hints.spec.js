// @ts-check
/** The three hints of the first use: their place, and when they appear and disappear. */

import { covered } from '../../covered.js';
import { reloadSaved } from '../project-files.js';
import { accessible, expect, idle, openBoard, press, reach, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page @param {string} text */
const hint = (page, text) => page.locator('.hint').filter({ hasText: text });
const none = (/** @type {Page} */ page) => expect(page.locator('.hint')).toBeEmpty();

/** Whether the hint is inside of the window and next to the page, and the controls that something covers. @param {Page} page */
const place = async (page) => {
  const [box, art] = await Promise.all(['.hint', '.page-canvas'].map((one) => page.locator(one).boundingBox()));
  if (!box || !art) throw new Error('no hint or no page');
  const { width, height } = /** @type {{ width: number, height: number }} */ (page.viewportSize());
  const inside = box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height;
  const apart =
    box.x >= art.x + art.width ||
    box.x + box.width <= art.x ||
    box.y >= art.y + art.height ||
    box.y + box.height <= art.y;
  return { inside, apart, names: await page.evaluate(covered) };
};
const RIGHT = { inside: true, apart: true, names: [] };

for (const viewport of [
  { width: 1280, height: 800 },
  { width: 360, height: 740 },
  { width: 844, height: 390 },
]) {
  const touch = viewport.width < 1000;
  test.describe(`${viewport.width} by ${viewport.height}`, () => {
    test.use({ viewport, hasTouch: touch, isMobile: touch });

    test('each hint appears once, covers neither page nor control, and disappears after its action', async ({
      page,
    }) => {
      await openBoard(page);
      await expect(hint(page, 'Shuffle until you like it')).toBeVisible();
      expect(await place(page)).toEqual(RIGHT);
      // A hint does not replace a tool.
      await expect(await reach(page, 'Add page')).toBeVisible();
      await accessible(page);
      // The list of all tools takes the place of hints.
      if (!touch) await page.getByRole('button', { name: 'More', exact: true }).click();
      await press(page, 'Shuffle');
      await none(page);

      // Nothing covers the last panel of a random layout.
      const panel = page.getByRole('group', { name: /^Panel \d+ of/ }).last();
      if (touch) await panel.tap();
      else await panel.hover();
      await expect(hint(page, 'Drag to move the picture')).toBeVisible();
      expect(await place(page)).toEqual(RIGHT);
      if (touch) for (const name of ['Crop', 'Zoom in']) await (await reach(page, name)).tap();
      else await page.mouse.wheel(0, -200);
      await idle(page);
      await none(page);

      for (let i = 0; i < 2; i += 1) await page.keyboard.press('Escape');
      await press(page, 'Shuffle');
      await expect(hint(page, 'Lock the parts that you like')).toBeVisible();
      expect(await place(page)).toEqual(RIGHT);
      await page.getByRole('button', { name: 'Lock style' }).click();
      await none(page);
    });
  });
}

test('a hint that was closed does not appear again, until the help shows the hints again', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  await expect(hint(page, 'Shuffle until you like it')).toBeVisible();
  await page.keyboard.press('Escape');
  await none(page);
  await reloadSaved(page);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await press(page, 'Shuffle');
  await press(page, 'Shuffle');
  await expect(hint(page, 'Lock the parts')).toBeVisible();
  await page.keyboard.press('Escape');
  await none(page);
  await page.keyboard.press('?');
  await page.getByRole('button', { name: 'Show the hints again' }).click();
  await expect(hint(page, 'Shuffle until you like it')).toBeVisible();
});
