// @ts-check
import { readFile } from 'node:fs/promises';
import { PNG } from '../../../../www/testing.ts';
import { contents, expect, idle, openBoard, picture, tab, test } from '../support.js';

test('from the start to the file by keyboard alone', async ({ page }) => {
  await page.goto('./');
  await idle(page);
  for (let i = 0; i < 12; i += 1) {
    await page.keyboard.press('Tab');
    if (await page.evaluate(() => document.activeElement?.textContent === 'Try the sample album')) break;
  }
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  const first = await picture(page);
  await page.keyboard.press('Space');
  await idle(page);
  expect(await picture(page)).not.toBe(first);
  await page.keyboard.press('Control+z');
  await idle(page);
  expect(await picture(page)).toBe(first);
  await page.keyboard.press('Shift+Control+Z');
  await idle(page);
  expect(await picture(page)).not.toBe(first);
  const waiting = page.waitForEvent('download', { timeout: 60_000 });
  await page.keyboard.press('Control+s');
  const png = PNG.sync.read(await readFile(await (await waiting).path()));
  expect([png.width, png.height]).toEqual([2480, 3508]);
});

test('L, S and P shuffle their part', async ({ page }) => {
  await openBoard(page);
  for (const [key, part] of /** @type {const} */ ([
    ['l', 'layout'],
    ['s', 'style'],
    ['p', 'photos'],
  ])) {
    const before = await contents(page);
    await page.keyboard.press(key);
    await idle(page);
    expect((await contents(page))[part]).not.toEqual(before[part]);
  }
});

test('arrows move between the panels, which are one tab stop', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  const option = page.getByRole('listbox', { name: 'Layouts' }).getByRole('option');
  await option.first().click();
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('6');
  await idle(page);
  const panels = page.getByRole('group', { name: /^Panel \d of \d$/ });
  expect(
    await panels.evaluateAll(
      (list) => list.filter((panel) => /** @type {HTMLElement} */ (panel).tabIndex === 0).length,
    ),
  ).toBe(1);
  await panels.first().focus();
  /** @type {Set<string | null | undefined>} */
  const seen = new Set();
  for (const key of ['ArrowDown', 'ArrowRight', 'ArrowDown', 'ArrowRight', 'ArrowUp', 'ArrowLeft', 'ArrowUp']) {
    seen.add(await page.evaluate(() => document.activeElement?.getAttribute('aria-label')));
    await page.keyboard.press(key);
  }
  expect(seen.size).toBeGreaterThanOrEqual(3);
  for (const name of seen) expect(name).toMatch(/^Panel \d of 6$/);
});

test('lists are walked with arrows and chosen with Enter', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Styles');
  const box = page.getByRole('listbox', { name: 'Styles' });
  await box.getByRole('option', { selected: true }).focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect(box.getByRole('option').nth(1)).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect(box.getByRole('option').last()).toHaveAttribute('aria-selected', 'true');
});

test('? lists the keys, Escape closes the list', async ({ page }) => {
  await openBoard(page, ['cat.jpg']);
  await page.keyboard.press('?');
  const dialog = page.getByRole('dialog', { name: 'Keyboard shortcuts' });
  await expect(dialog).toBeVisible();
  const before = await picture(page);
  await page.keyboard.press('Space');
  expect(await picture(page)).toBe(before);
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
});
