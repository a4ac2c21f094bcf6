// @ts-check
/** Photos in their panels: crops by mouse and keyboard, swaps, locks and focus points. */

import { boxOf, changed, drag, four, panel } from '../panels.js';
import { contents, expect, idle, picture, press, reach, tab, sharedBoardTest as test } from '../support.js';

test('mouse: the wheel zooms, a drag pans, a double click fits, and Reset restores the crop', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  const box = await boxOf(page, 2);
  const middle = /** @type {[number, number]} */ ([box.x + box.width / 2, box.y + box.height / 2]);
  await page.mouse.move(...middle);
  await page.mouse.wheel(0, -240);
  await idle(page);
  const near = await picture(page);
  expect(changed(start, near)).toEqual([2]);
  await drag(page, middle, [middle[0] + box.width * 0.3, middle[1] + box.height * 0.2]);
  const panned = await picture(page);
  expect(changed(near, panned)).toEqual([2]);
  // A drag beyond the edge of the photo stops at the edge.
  for (let i = 0; i < 4; i += 1) await drag(page, middle, [box.x + box.width - 6, middle[1]]);
  const edge = await picture(page);
  await drag(page, middle, [box.x + box.width - 6, middle[1]]);
  expect(changed(edge, await picture(page))).toEqual([]);
  await panel(page, 2).click();
  await press(page, 'Reset');
  expect(changed(start, await picture(page))).toEqual([]);
  await page.mouse.move(...middle);
  await page.mouse.wheel(0, -240);
  await idle(page);
  await panel(page, 2).dblclick();
  await idle(page);
  expect(changed(near, await picture(page))).toEqual([2]);
});

test('a drag is one undo step, and a new gutter keeps a manual crop', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  const box = await boxOf(page, 1);
  await page.mouse.move(box.x + 60, box.y + 60);
  await page.mouse.wheel(0, -240);
  await idle(page);
  const near = await picture(page);
  await drag(page, [box.x + 60, box.y + 60], [box.x + 20, box.y + 30]);
  await press(page, 'Undo');
  expect(changed(near, await picture(page))).toEqual([]);
  await tab(page, 'Page');
  await page.getByRole('slider', { name: 'Gutter' }).fill('3');
  await idle(page);
  await page.getByRole('slider', { name: 'Gutter' }).fill('1.8');
  await idle(page);
  const back = await picture(page);
  expect(changed(start, back)).toContain(1);
});

test('keyboard: Enter starts moving a photo, arrows pan, plus zooms, 0 resets, Escape ends', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  await panel(page, 3).focus();
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('+');
  await idle(page);
  const near = await picture(page);
  expect(changed(start, near)).toEqual([3]);
  await page.keyboard.press('Enter');
  await expect(page.getByText('Arrow keys move the photo')).toBeVisible();
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Shift+ArrowLeft');
  await idle(page);
  const panned = await picture(page);
  expect(changed(near, panned)).toEqual([3]);
  await page.keyboard.press('0');
  await idle(page);
  expect(changed(start, await picture(page))).toEqual([]);
  await page.keyboard.press('Escape');
  await expect(page.getByText('Arrow keys move the photo')).toHaveCount(0);
  // The arrows move between panels again.
  await page.keyboard.press('ArrowRight');
  await expect(panel(page, 4)).toBeFocused();
});

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
  await (await reach(page, 'Swap photo')).click();
  await panel(page, 3).click();
  await idle(page);
  await page.keyboard.press('Escape');
  expect((await contents(page)).photos).toEqual([before[0], before[2], before[1], before[3]]);
  await panel(page, 1).focus();
  await page.keyboard.press('Shift+Enter');
  await (await reach(page, 'Swap photo')).focus();
  await page.keyboard.press('Enter');
  await panel(page, 2).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  await page.keyboard.press('Escape');
  expect((await contents(page)).photos).toEqual([before[2], before[0], before[1], before[3]]);
});

test('a photo of the tray is placed by a drop on a panel and by a button', async ({ page }) => {
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

test('Shuffle does not change the photo and crop of a locked panel', async ({ page }) => {
  await four(page);
  await panel(page, 2).click();
  for (const name of ['Crop', 'Zoom in', 'Done', 'Lock']) await press(page, name);
  await expect(await reach(page, 'Crop')).toBeDisabled();
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

test('a focus point is one undo step and is shown in the panel', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  await panel(page, 1).click();
  await (await reach(page, 'Focus point')).click();
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
