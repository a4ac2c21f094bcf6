// @ts-check
/** Room for the page: what folds, what floats, and the page alone. */

import { expect, idle, openBoard, test } from '../support.js';

// Where versions are told in words.
test.use({ viewport: { width: 1366, height: 768 } });

test('More ideas fold away for the page, and stay so', async ({ page }) => {
  await openBoard(page);
  const height = async () => (await page.locator('.page-canvas').boundingBox())?.height ?? 0;
  const before = await height();
  await expect(page.getByRole('heading', { name: 'More ideas' })).toBeVisible();
  await page.getByRole('button', { name: 'Fold More ideas' }).click();
  await expect(page.getByRole('button', { name: /^Alternative \d/ })).toHaveCount(0);
  await expect.poll(height).toBeGreaterThan(before + 50);
  await page.reload();
  await idle(page);
  await page.getByRole('button', { name: 'Unfold More ideas' }).click();
  await expect(page.getByRole('button', { name: 'Alternative 1', exact: true })).toBeVisible();
});

test('an idea is seen large with its names, and the page stays', async ({ page }) => {
  await openBoard(page);
  const version = page.getByRole('button', { name: /^Pages shown/ });
  await expect(version).toHaveText('Version 1 of 1');
  await page.getByRole('button', { name: 'Alternative 2', exact: true }).hover();
  await expect(page.locator('.glimpse [data-drawn=true]')).toBeVisible();
  await expect(page.locator('.glimpse-name')).toHaveText(/.+ · .+/);
  await expect(version).toHaveText('Version 1 of 1');
});

test('the page has the window to itself, shuffles there, and Escape brings the rest back', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('button', { name: 'Full screen' }).click();
  await expect(page.getByRole('button', { name: 'Export' })).toBeHidden();
  await page.keyboard.press('Space');
  await idle(page);
  await page.keyboard.press('Escape');
  await expect(page.getByRole('button', { name: /^Pages shown/ })).toHaveText('Version 2 of 2');
});

test('the tools of a panel stand beside the page, at its height, with their names', async ({ page }) => {
  await openBoard(page);
  const canvas = await page.locator('.page-canvas').boundingBox();
  for (const n of [1, 3]) {
    await page.getByRole('group', { name: new RegExp(`^Panel ${n} of`) }).click();
    const tools = page.getByRole('toolbar', { name: 'Tools for the photo of the panel' });
    const box = await tools.boundingBox();
    expect(box?.x).toBeGreaterThan((canvas?.x ?? 0) + (canvas?.width ?? 0));
    await expect(tools.getByRole('button', { name: 'Swap photo' })).toHaveText('Swap');
  }
  await page.getByRole('button', { name: 'Star this photo' }).click();
  await expect(
    page.getByRole('region', { name: 'Photos' }).getByRole('button', { name: /^Star /, pressed: true }),
  ).toHaveCount(1);
});
