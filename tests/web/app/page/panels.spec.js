// @ts-check
/** Panels: split, joined, merged into one photo across several panels, selected by mouse, keyboard and touch. */

import { four } from '../panels.js';
import {
  accessible,
  choose,
  contents,
  expect,
  idle,
  openBoard,
  picture,
  press,
  reach,
  tab,
  sharedBoardTest as test,
} from '../support.js';

test('a panel is split into rows and columns and removed', async ({ page }) => {
  await four(page);
  await tab(page, 'Layouts');
  await (await reach(page, 'Edit layout')).click();
  const panels = page.getByRole('group', { name: /^Panel \d+ of/ });
  await expect(await reach(page, 'Split into rows')).toBeDisabled();
  await panels.nth(1).click();
  await press(page, 'Split into rows');
  await expect(panels).toHaveCount(5);
  await panels.nth(0).click();
  await press(page, 'Split into columns');
  await expect(panels).toHaveCount(6);
  await panels.nth(5).click();
  await press(page, 'Remove panel');
  await expect(panels).toHaveCount(5);
  for (const count of [6, 5, 4]) {
    await press(page, 'Undo');
    await expect(panels).toHaveCount(count);
  }
});

test('one photo is put across panels and split again by mouse', async ({ page }) => {
  await four(page);
  const panels = page.getByRole('group', { name: /^Panel \d of/ });
  const merge = page.getByRole('button', { name: 'One photo across panels', exact: true });
  await panels.nth(0).click();
  await panels.nth(3).click({ modifiers: ['Shift'] });
  await reach(page, 'One photo across panels');
  await expect(merge).toBeDisabled();
  await expect(merge).toHaveAttribute('title', /do not touch/);
  await panels.nth(1).click({ modifiers: ['ControlOrMeta'] });
  const apart = await picture(page);
  await press(page, 'One photo across panels');
  expect(await picture(page)).not.toBe(apart);
  const { photos } = await contents(page);
  const shown = photos.map((photo) => photo?.replace(', selected', ''));
  expect(shown[0]).toBe(shown[1]);
  expect(shown[1]).toBe(shown[3]);
  expect(shown[2]).not.toBe(shown[0]);
  await press(page, 'Split');
  expect(new Set((await contents(page)).photos).size).toBe(4);
  await press(page, 'Undo');
  await press(page, 'Undo');
  expect(await picture(page)).toBe(apart);
});

test('joined panels show the first of their photos', async ({ page }) => {
  await four(page);
  const panels = page.getByRole('group', { name: /^Panel \d of/ });
  const join = page.getByRole('button', { name: 'Join panels', exact: true });
  await panels.nth(0).click();
  await panels.nth(3).click({ modifiers: ['Shift'] });
  await reach(page, 'Join panels');
  await expect(join).toHaveAttribute('title', /do not form one panel/);
  await panels.nth(3).click({ modifiers: ['Shift'] });
  const { photos } = await contents(page);
  await panels.nth(2).click({ modifiers: ['Shift'] });
  await press(page, 'Join panels');
  await expect(panels).toHaveCount(3);
  const after = await contents(page);
  const plain = (/** @type {(string | null)[]} */ list) => list.map((photo) => photo?.replace(', selected', ''));
  expect(plain(after.photos)).toEqual(plain([photos[0], photos[1], photos[3]]));
  const [joined, upper, lower] = await panels.evaluateAll((list) => list.map((one) => one.getBoundingClientRect()));
  expect(joined.bottom).toBeCloseTo(lower.bottom, 0);
  expect(joined.top).toBeCloseTo(upper.top, 0);
  await press(page, 'Undo');
  await expect(panels).toHaveCount(4);
  expect(plain((await contents(page)).photos)).toEqual(plain(photos));
});

test('one photo is put across panels by keyboard', async ({ page }) => {
  await four(page);
  await page.getByRole('group', { name: 'Panel 1 of 4' }).focus();
  await page.keyboard.press('Shift+Enter');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+Enter');
  await expect(page.getByText('2 panels selected')).toBeAttached();
  await (await reach(page, 'One photo across panels')).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  const { photos } = await contents(page);
  expect(photos[0]).toBe(photos[1]);
  await page.keyboard.press('Escape');
  await expect(page.getByText('panels selected')).toHaveCount(0);
  // Shuffle keeps at most one photo across panels.
  await press(page, 'Shuffle');
});

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  test(`axe finds nothing while panels are selected and cuts are edited, in ${colorScheme} colours`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme });
    await openBoard(page);
    await tab(page, 'Layouts');
    await press(page, 'New layout');
    await (await reach(page, 'Edit layout')).click();
    await page.getByRole('group', { name: /^Panel 1 of/ }).click({ position: { x: 20, y: 20 } });
    await tab(page, 'Page');
    await page.getByRole('combobox', { name: 'Page size' }).selectOption('custom');
    await idle(page);
    await accessible(page);
  });
}

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });

  test('panels are selected, and one photo is put across them, by touch', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Layouts', exact: true }).click();
    await choose(page, 'grid', 'Four');
    await page.getByRole('button', { name: 'Close' }).click();
    const panels = page.getByRole('group', { name: /^Panel \d of/ });
    await panels.nth(0).tap();
    await (await reach(page, 'Select panels')).tap();
    await panels.nth(1).tap();
    await page.getByRole('button', { name: 'One photo across panels', exact: true }).tap();
    await idle(page);
    const photos = await panels.evaluateAll((list) => list.map((panel) => panel.getAttribute('aria-description')));
    expect(photos[0]).toBe(photos[1]);
    await accessible(page);
  });
});
