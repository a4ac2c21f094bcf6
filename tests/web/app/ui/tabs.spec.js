// @ts-check
/** The tabs next to the page: keyboard, lists, and the preview of a style. */

import { contents, expect, idle, openBoard, picture, tab, sharedBoardTest as test } from '../support.js';

test('arrows, Home and End change the tab, and a search text remains', async ({ page }) => {
  await openBoard(page);
  const list = page.getByRole('tablist', { name: 'Page tools' });
  await expect(list.getByRole('tab')).toHaveText(['Styles', 'Layouts', 'Text', 'Page']);
  await page.getByRole('searchbox', { name: 'Search styles' }).fill('noir');
  const names = page.getByRole('listbox', { name: 'Styles' }).getByRole('option');
  await expect(names.first()).toHaveAccessibleName(/noir/i);
  const found = await names.count();
  await list.getByRole('tab', { name: 'Styles' }).focus();
  for (const [key, name] of [
    ['ArrowRight', 'Layouts'],
    ['End', 'Page'],
    ['ArrowRight', 'Styles'],
    ['ArrowLeft', 'Page'],
    ['Home', 'Styles'],
  ]) {
    await page.keyboard.press(key);
    await expect(list.getByRole('tab', { name, selected: true })).toBeFocused();
    await expect(page.getByRole('tabpanel')).toHaveCount(1);
    await expect(page.getByRole('tabpanel', { name })).toBeVisible();
  }
  expect(await names.count()).toBe(found);
  await page.getByRole('searchbox', { name: 'Search styles' }).fill('');
});

test('layouts show their number of panels', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Family' }).selectOption('grid');
  const four = page.getByRole('listbox', { name: 'Layouts' }).getByRole('option', { name: 'Four', exact: true });
  await expect(four).toHaveAccessibleDescription('4 panels');
  await expect(four.getByText('4 panels')).toBeVisible();
  await page.getByRole('combobox', { name: 'Family' }).selectOption('');
});

test('pointing at a style shows the page in this style, and Escape closes the preview', async ({ page }) => {
  await openBoard(page);
  const before = await picture(page);
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'Hard Boiled' }).hover();
  const seen = page.locator('.glimpse [data-drawn=true]');
  await expect(seen).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(seen).toHaveCount(0);
  expect(await picture(page)).toBe(before);
});

for (const way of ['click', 'Enter'])
  test(`choosing a style by ${way} closes the preview, and the page shows the style`, async ({ page }) => {
    await openBoard(page);
    const before = await picture(page);
    const style = page
      .getByRole('listbox', { name: 'Styles' })
      .getByRole('option', { selected: false })
      .filter({ visible: true })
      .nth(1);
    const seen = page.locator('.glimpse [data-drawn=true]');
    await style.hover();
    if (way === 'Enter') {
      await page.mouse.move(5, 5);
      await style.focus();
      await page.keyboard.press('ArrowRight');
    }
    await expect(seen).toBeVisible();
    if (way === 'click') await page.mouse.down().then(() => page.mouse.up());
    else await page.keyboard.press('Enter');
    await expect(seen).toHaveCount(0);
    await idle(page);
    await expect(seen).toHaveCount(0);
    expect(await picture(page)).not.toBe(before);
    await page.getByRole('button', { name: 'Undo', exact: true }).click();
    await idle(page);
  });

test('a text item that is selected on the page opens its tab', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Text');
  await page.getByRole('button', { name: 'Add caption' }).click();
  await expect(page.getByRole('textbox', { name: /^Text of/ })).toBeFocused();
  await page.keyboard.type('MORNING');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await idle(page);
  await tab(page, 'Page');
  await page.locator('.words').getByRole('button', { name: 'Caption: MORNING' }).click();
  await expect(page.getByRole('tab', { name: 'Text', selected: true })).toBeVisible();
});

test('styles are filtered by kind, and the last applied style is first after a reload', async ({ page }) => {
  await openBoard(page);
  const box = page.getByRole('listbox', { name: 'Styles' });
  const kinds = page.getByRole('combobox', { name: 'Style families' });
  await box.hover();
  await expect(kinds).toHaveCSS('opacity', '1');
  await kinds.selectOption('Noir');
  await expect(box.getByRole('group')).toHaveCount(1);
  await box.getByRole('option', { name: 'Moonlight' }).click();
  await idle(page);
  expect((await contents(page)).style).toBe('Moonlight');
  await kinds.selectOption('All');
  await page.reload();
  await idle(page);
  await expect(box.getByRole('group').first()).toHaveAccessibleName('Recent');
  await expect(box.getByRole('option', { name: 'Moonlight' })).toHaveCount(1);
});
