// @ts-check
import { boxOf, changed, drag, four, panel } from '../panel-hands.js';
import { expect, idle, picture, press, tab, test } from '../support.js';

test('by mouse: wheel zooms, drag pans, double click fits, Reset restores', async ({ page }) => {
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
  // Far beyond the photo's edge: it stops there, and no empty edge shows.
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

test('a drag is one undo step, and a crop made by hand outlives a longer gutter', async ({ page }) => {
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

test('by keyboard: Enter takes the photo, arrows pan, plus and minus zoom, Escape leaves', async ({ page }) => {
  await four(page);
  const start = await picture(page);
  await panel(page, 3).focus();
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('+');
  await idle(page);
  const near = await picture(page);
  expect(changed(start, near)).toEqual([3]);
  await page.keyboard.press('Enter');
  await expect(page.getByText('Arrows move the photo')).toBeVisible();
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Shift+ArrowLeft');
  await idle(page);
  const panned = await picture(page);
  expect(changed(near, panned)).toEqual([3]);
  await page.keyboard.press('0');
  await idle(page);
  expect(changed(start, await picture(page))).toEqual([]);
  await page.keyboard.press('Escape');
  await expect(page.getByText('Arrows move the photo')).toHaveCount(0);
  // Arrows go between panels again.
  await page.keyboard.press('ArrowRight');
  await expect(panel(page, 4)).toBeFocused();
});
