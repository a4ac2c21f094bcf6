// @ts-check
import { accessible, add, expect, idle, openBoard, test } from './support.js';

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  test.describe(`in ${colorScheme}`, () => {
    test.use({ colorScheme });

    test('axe finds nothing on the start', async ({ page }) => {
      await page.goto('./');
      await idle(page);
      await accessible(page);
    });

    test('axe finds nothing on the board, its dialogs and its messages', async ({ page }) => {
      await openBoard(page);
      await accessible(page);
      await page.getByRole('button', { name: 'Lock style' }).click();
      await add(page, [{ name: 'notes.txt', mimeType: 'text/plain', buffer: Buffer.from('no photo') }]);
      await expect(page.getByRole('alert')).toContainText('notes.txt');
      await accessible(page);
      await page.getByRole('button', { name: 'Export', exact: true }).click();
      await expect(page.getByRole('dialog').locator('canvas[data-drawn=true]')).toBeVisible();
      await accessible(page);
      await page.keyboard.press('Escape');
      await page.keyboard.press('?');
      await accessible(page);
    });

    test('axe finds nothing on a phone', async ({ page }) => {
      await page.setViewportSize({ width: 360, height: 740 });
      await openBoard(page);
      await accessible(page);
      for (const name of ['Photos', 'Styles', 'Layouts', 'Page settings']) {
        await page.getByRole('button', { name, exact: true }).click();
        await accessible(page);
        await page.getByRole('button', { name: 'Close' }).click();
      }
    });
  });
}
