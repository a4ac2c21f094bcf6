// @ts-check
/** Shuffle, locks, lists of layouts and styles, versions, undo and page settings. */

import {
  contents,
  expect,
  idle,
  openBoard,
  openNewBoard,
  picture,
  press,
  tab,
  sharedBoardTest as test,
} from '../support.js';

test('Shuffle shows a new page each time', async ({ page }) => {
  await openBoard(page);
  const seen = new Set([await picture(page)]);
  for (let i = 0; i < 6; i += 1) {
    await press(page, 'Shuffle');
    seen.add(await picture(page));
  }
  expect(seen.size).toBe(7);
});

test('Shuffle style, layout and photos each change only their part', async ({ page }) => {
  await openBoard(page);
  const before = await contents(page);
  await press(page, 'Shuffle style');
  const style = await contents(page);
  expect(style).toEqual({ ...before, style: expect.anything() });
  expect(style.style).not.toBe(before.style);
  await press(page, 'Shuffle layout');
  const layout = await contents(page);
  expect(layout.layout).not.toBe(style.layout);
  expect(layout.style).toBe(style.style);
  await press(page, 'Shuffle photos');
  const photos = await contents(page);
  expect([photos.layout, photos.style]).toEqual([layout.layout, layout.style]);
  expect(photos.photos).not.toEqual(layout.photos);
});

/**
 * Returns the photos of two pages in order, as far as both have panels. Panels that share an image count once.
 * @param {(string | null)[]} one
 * @param {(string | null)[]} other
 */
function commonPhotos(one, other) {
  const [a, b] = [[...new Set(one)], [...new Set(other)]];
  const count = Math.min(a.length, b.length);
  return [a.slice(0, count), b.slice(0, count)];
}

for (const part of /** @type {const} */ (['layout', 'style', 'photos'])) {
  test(`Shuffle does not change a locked ${part}`, async ({ page }) => {
    await openBoard(page);
    const before = await contents(page);
    await page.getByRole('button', { name: `Lock ${part}` }).click();
    await expect(page.getByRole('button', { name: `Lock ${part}` })).toHaveAttribute('aria-pressed', 'true');
    let others = 0;
    for (let i = 0; i < 6; i += 1) {
      await press(page, 'Shuffle');
      const now = await contents(page);
      if (part === 'photos') {
        const [photos, locked] = commonPhotos(now.photos, before.photos);
        expect(photos).toEqual(locked);
      } else expect(now[part]).toBe(before[part]);
      if (JSON.stringify(now) !== JSON.stringify(before)) others += 1;
    }
    expect(others).toBeGreaterThan(0);
  });
}

test('a click in the lists applies a layout and a style', async ({ page }) => {
  await openBoard(page);
  for (const list of /** @type {const} */ (['Layouts', 'Styles'])) {
    await tab(page, list);
    const box = page.getByRole('listbox', { name: list });
    // The list scrolls to its selected option when it opens.
    await expect(box.getByRole('option', { selected: true })).toBeInViewport();
    const before = await picture(page);
    const option = box.getByRole('option', { selected: false }).nth(2);
    const name = await option.getAttribute('aria-label');
    await option.click();
    await idle(page);
    await expect(box.getByRole('option', { selected: true })).toHaveAccessibleName(String(name));
    expect(await picture(page)).not.toBe(before);
  }
});

test('layouts are filtered by family and number of panels, and Shuffle does not change the number', async ({
  page,
}) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  const box = page.getByRole('listbox', { name: 'Layouts' });
  const all = await box.getByRole('option').count();
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('4');
  await idle(page);
  const four = await box.getByRole('option').count();
  expect(four).toBeLessThan(all);
  for (let i = 0; i < 4; i += 1) {
    expect((await contents(page)).photos.length).toBe(4);
    await press(page, 'Shuffle');
  }
  await page.getByRole('combobox', { name: 'Family' }).selectOption({ index: 1 });
  expect(await box.getByRole('option').count()).toBeLessThan(four);
});

test('Previous version and Next version step through the versions', async ({ page }) => {
  await openNewBoard(page);
  const pages = [await picture(page)];
  for (let i = 0; i < 3; i += 1) {
    await press(page, 'Shuffle');
    pages.push(await picture(page));
  }
  await expect(page.getByRole('button', { name: 'Next version' })).toBeDisabled();
  for (const expected of [2, 1, 0]) {
    await press(page, 'Previous version');
    expect(await picture(page)).toBe(pages[expected]);
  }
  await expect(page.getByRole('button', { name: 'Previous version' })).toBeDisabled();
  await press(page, 'Next version');
  expect(await picture(page)).toBe(pages[1]);
  // A new page is added at the end, so no version is lost.
  await press(page, 'Shuffle');
  await press(page, 'Previous version');
  expect(await picture(page)).toBe(pages[3]);
});

test('undo and redo step through every edit', async ({ page }) => {
  await openBoard(page);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  const states = [await picture(page)];
  await press(page, 'Shuffle layout');
  states.push(await picture(page));
  await press(page, 'Shuffle style');
  states.push(await picture(page));
  for (const expected of [1, 0]) {
    await press(page, 'Undo');
    expect(await picture(page)).toBe(states[expected]);
  }
  for (const expected of [1, 2]) {
    await press(page, 'Redo');
    expect(await picture(page)).toBe(states[expected]);
  }
  await page.getByRole('button', { name: 'Lock style' }).click();
  await press(page, 'Undo');
  await expect(page.getByRole('button', { name: 'Lock style' })).toHaveAttribute('aria-pressed', 'false');
});

test('page settings redraw the page at once, and a drag is one undo step', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Page');
  const settings = page.getByRole('region', { name: 'Page settings' });
  const before = await picture(page);
  const shown = new Set([before]);
  for (const name of ['Gutter', 'Margin', 'Border', 'Corner radius']) {
    const slider = settings.getByRole('slider', { name });
    await slider.fill('1.2');
    await idle(page);
    shown.add(await picture(page));
    await expect(slider).toHaveAttribute('aria-valuetext', '1.2%');
  }
  await settings.getByLabel('Paper colour').fill('#ffcc00');
  await idle(page);
  shown.add(await picture(page));
  await settings.getByLabel('Border colour').fill('#0044ff');
  await idle(page);
  shown.add(await picture(page));
  expect(shown.size).toBe(7);
  for (let i = 0; i < 6; i += 1) await press(page, 'Undo');
  expect(await picture(page)).toBe(before);
});

test('another page size changes the shape of the page', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Page');
  await page.getByRole('combobox', { name: 'Page size' }).selectOption('square');
  await idle(page);
  const box = await page.locator('.page-canvas').boundingBox();
  expect(Math.abs((box?.width ?? 0) / (box?.height ?? 1) - 1)).toBeLessThan(0.02);
});

test('the page is redrawn when the window changes its size', async ({ page }) => {
  await openBoard(page);
  const before = await page.locator('.page-canvas').getAttribute('width');
  await page.setViewportSize({ width: 1600, height: 1000 });
  await expect(page.locator('.page-canvas')).not.toHaveAttribute('width', String(before));
  const difference = () =>
    page
      .locator('.page-canvas')
      .evaluate((canvas) =>
        Math.abs(/** @type {HTMLCanvasElement} */ (canvas).width - canvas.clientWidth * Math.min(2, devicePixelRatio)),
      );
  await expect.poll(difference).toBeLessThanOrEqual(1);
});
