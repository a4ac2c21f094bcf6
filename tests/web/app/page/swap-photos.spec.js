// @ts-check
import { boxOf, changed, drag, four, panel } from '../panel-hands.js';
import { contents, expect, idle, picture, press, test } from '../support.js';

test('photos are swapped by a drag, by two clicks and by keyboard', async ({ page }) => {
  await four(page);
  const before = (await contents(page)).photos;
  const [a, d] = [await boxOf(page, 1), await boxOf(page, 4)];
  await drag(page, [a.x + a.width / 2, a.y + a.height / 2], [d.x + d.width / 2, d.y + d.height / 2]);
  const dragged = (await contents(page)).photos;
  expect(dragged).toEqual([before[3], before[1], before[2], before[0]]);
  await press(page, 'Undo');
  expect((await contents(page)).photos).toEqual(before);
  await panel(page, 2).click();
  await page.getByRole('button', { name: 'Swap photo' }).click();
  await panel(page, 3).click();
  await idle(page);
  await page.keyboard.press('Escape');
  expect((await contents(page)).photos).toEqual([before[0], before[2], before[1], before[3]]);
  await panel(page, 1).focus();
  await page.keyboard.press('Shift+Enter');
  await page.getByRole('button', { name: 'Swap photo' }).focus();
  await page.keyboard.press('Enter');
  await panel(page, 2).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  await page.keyboard.press('Escape');
  expect((await contents(page)).photos).toEqual([before[2], before[0], before[1], before[3]]);
});

test('a photo of the tray is dropped on a panel, or put there with a button', async ({ page }) => {
  await four(page);
  const { photos } = await contents(page);
  const all = await page
    .getByRole('region', { name: 'Photos' })
    .getByRole('checkbox')
    .evaluateAll((list) => list.map((box) => String(box.getAttribute('aria-label')).slice('Use '.length)));
  const [first, second] = all.filter((name) => !photos.includes(name));
  const item = page
    .getByRole('region', { name: 'Photos' })
    .getByRole('listitem')
    .filter({ has: page.getByLabel(`Use ${first}`) });
  await item.dragTo(panel(page, 2));
  await idle(page);
  expect((await contents(page)).photos[1]).toBe(first);
  await panel(page, 4).focus();
  await page.keyboard.press('Shift+Enter');
  await page.getByRole('button', { name: `Put ${second} in panel 4` }).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  await page.keyboard.press('Escape');
  expect((await contents(page)).photos[3]).toBe(second);
});

test('a locked panel keeps its photo and crop through every shuffle', async ({ page }) => {
  await four(page);
  await panel(page, 2).click();
  await page.getByRole('button', { name: 'Zoom in' }).click();
  await page.getByRole('button', { name: 'Lock panel' }).click();
  await idle(page);
  await expect(page.getByRole('button', { name: 'Zoom in' })).toBeDisabled();
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Lock style' }).click();
  const before = await picture(page);
  const { photos } = await contents(page);
  for (const name of ['Shuffle', 'Shuffle photos', 'Shuffle']) {
    await press(page, name);
    const now = await contents(page);
    expect(now.photos[1]).toBe(photos[1]);
    expect(changed(before, await picture(page))).not.toContain(2);
  }
});

test('a focus point is honoured by the crops that follow', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  await panel(page, 1).click();
  await page.getByRole('button', { name: 'Focus point' }).click();
  const box = await boxOf(page, 1);
  await page.mouse.click(box.x + 8, box.y + 8);
  await idle(page);
  await expect(page.locator('.panel-focus')).toBeVisible();
  const focused = await picture(page);
  await press(page, 'Undo');
  expect(changed(start, await picture(page))).toEqual([]);
  await press(page, 'Redo');
  expect(changed(focused, await picture(page))).toEqual([]);
});
