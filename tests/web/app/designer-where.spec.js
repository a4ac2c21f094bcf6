// @ts-check
/** Layers and blocks that are for the subject or for the background: chosen in the designer, told by the file, drawn on the page. */

import { addBlock, button, cards, drawn, preview, region } from './designer-hands.js';
import { accessible, add, expect, idle, photos, picture, detectingTest as test } from './support.js';

const MASKED = { timeout: 120_000 };

test('a block is for the background alone, and one undo has it everywhere again', async ({ page }) => {
  test.setTimeout(240_000);
  await page.goto('./');
  await add(page, await photos('macaw.jpg', 'camera.jpg', 'dahlia.jpg'));
  await expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);
  await idle(page);
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  // One in colour: another of them is gray by itself, and chance has a say in which is shown.
  await region(page).getByRole('button', { name: 'Preview macaw.jpg' }).click();
  await drawn(page);
  await addBlock(page, 'Grayscale');
  const everywhere = await preview(page);
  const where = cards(page).first().getByRole('combobox', { name: 'Area', exact: true });
  await expect(where).toHaveValue('');
  await where.selectOption('Background');
  await expect.poll(async () => (await preview(page)) !== everywhere).toBe(true);
  const behind = await preview(page);
  await where.selectOption('Subject');
  await expect.poll(async () => [everywhere, behind].includes(await preview(page))).toBe(false);
  await accessible(page);
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await expect.poll(async () => (await preview(page)) === behind).toBe(true);
  await undo.click();
  await expect.poll(async () => (await preview(page)) === everywhere).toBe(true);
  // The lines of a layer, by the keyboard.
  await addBlock(page, 'XDoG', 'Foreground layer');
  const lines = await preview(page);
  const layer = region(page).getByRole('combobox', { name: 'Area of the lines' });
  await layer.focus();
  await page.keyboard.press('ArrowDown');
  await expect(layer).toHaveValue('subject');
  await expect.poll(async () => (await preview(page)) !== lines).toBe(true);
  const before = await picture(page);
  await button(page, 'Use').click();
  await idle(page);
  expect((await picture(page)) !== before).toBe(true);
});
