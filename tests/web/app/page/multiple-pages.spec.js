// @ts-check
/** Comics of several pages: an album spread over pages; pages added, opened, moved and removed. */

import { photosOfPages, strip, thumb, thumbs } from '../page-strip.js';
import { touch, way } from '../touch.js';
import {
  SAMPLES,
  accessible,
  colours,
  contents,
  expect,
  idle,
  openBoard,
  picture,
  pixelsOf,
  press,
  tab,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** @param {Page} page */
async function spreadSamples(page) {
  await openBoard(page, SAMPLES);
  await press(page, 'Make pages from all photos');
}

test('the sample album is spread over pages with each photo once, and Undo restores the page', async ({ page }) => {
  await openBoard(page, SAMPLES);
  const before = await picture(page);
  await expect(thumbs(page)).toHaveCount(0);
  await press(page, 'Make pages from all photos');
  expect(await thumbs(page).count()).toBeGreaterThan(2);
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  const photos = (await photosOfPages(page)).flat();
  const used = await page.getByRole('region', { name: 'Photos' }).getByRole('checkbox', { checked: true }).count();
  expect(photos.length).toBe(used);
  expect(new Set(photos).size).toBe(used);
  await press(page, 'Undo');
  await expect(thumbs(page)).toHaveCount(0);
  expect(await picture(page)).toBe(before);
});

test('a new page has unused photos in the same style, and remains after a reload', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('3');
  await idle(page);
  const first = await contents(page);
  await press(page, 'Add page');
  await expect(thumb(page, 2)).toHaveAttribute('aria-current', 'true');
  const second = await contents(page);
  expect(second.style).toBe(first.style);
  expect(second.photos.filter((photo) => first.photos.includes(photo))).toEqual([]);
  await press(page, 'Shuffle photos');
  expect([...(await contents(page)).photos].sort()).toEqual([...second.photos].sort());
  const shown = await picture(page);
  await expect(page.getByText('Saved', { exact: true })).toBeVisible();
  await page.reload();
  await idle(page);
  expect(await picture(page)).toBe(shown);
  await expect(thumbs(page)).toHaveCount(2);
  await thumb(page, 1).click();
  await idle(page);
  expect(await contents(page)).toEqual(first);
});

test('pages are moved by buttons, keys and drags, and removed', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('2');
  await idle(page);
  await press(page, 'Add page');
  await press(page, 'Add page');
  const count = await thumbs(page).count();
  const pages = await photosOfPages(page);
  await thumb(page, 1).click();
  await press(page, 'Move page later');
  await expect(thumb(page, 2)).toHaveAttribute('aria-current', 'true');
  expect(await photosOfPages(page)).toEqual([pages[1], pages[0], ...pages.slice(2)]);
  await thumb(page, 2).click();
  await press(page, 'Move page earlier');
  await expect(strip(page).getByRole('button', { name: 'Move page earlier' })).toBeDisabled();
  await thumb(page, 1).press('Alt+ArrowDown');
  await expect(thumb(page, 2)).toBeFocused();
  await thumb(page, 2).press('Alt+ArrowUp');

  const [from, to] = [await thumb(page, 1).boundingBox(), await thumb(page, 3).boundingBox()];
  if (!from || !to) throw new Error('no pages');
  await page.mouse.move(from.x + 20, from.y + 20);
  await page.mouse.down();
  await page.mouse.move(from.x + 20, from.y + 60, { steps: 3 });
  await page.mouse.move(to.x + 20, to.y + to.height - 4, { steps: 5 });
  await page.mouse.up();
  await idle(page);
  await expect(thumb(page, 3)).toHaveAttribute('aria-current', 'true');
  expect(await photosOfPages(page)).toEqual([pages[1], pages[2], pages[0], ...pages.slice(3)]);

  await thumb(page, 2).click();
  await press(page, 'Remove page');
  await expect(thumbs(page)).toHaveCount(count - 1);
  expect(await photosOfPages(page)).toEqual([pages[1], pages[0], ...pages.slice(3)]);
  await press(page, 'Undo');
  await expect(thumbs(page)).toHaveCount(count);
  await press(page, 'Remove page');
  await press(page, 'Restore');
  expect(await thumbs(page).count()).toBe(count);
});

test('Page Up and Page Down change the page, and each page has its own versions', async ({ page }) => {
  await spreadSamples(page);
  const first = await picture(page);
  await page.keyboard.press('PageDown');
  await idle(page);
  await expect(thumb(page, 2)).toHaveAttribute('aria-current', 'true');
  const second = await picture(page);
  expect(second).not.toBe(first);
  await press(page, 'Shuffle');
  await page.keyboard.press('PageUp');
  await idle(page);
  expect(await picture(page)).toBe(first);
  await page.keyboard.press('PageDown');
  await press(page, 'Previous version');
  expect(await picture(page)).toBe(second);
  await expect(page.getByRole('button', { name: 'Previous version' })).toBeDisabled();
});

test('a style is applied to all pages, and the page size and a removed photo affect all pages', async ({ page }) => {
  await spreadSamples(page);
  await press(page, 'Shuffle style');
  const { style } = await contents(page);
  await press(page, 'Use this style on all pages');
  await expect(page.getByRole('button', { name: 'Use this style on all pages' })).toHaveCount(0);
  const before = await photosOfPages(page);
  expect((await contents(page)).style).toBe(style);
  await tab(page, 'Page');
  await page.getByRole('combobox', { name: 'Page size' }).selectOption('wide');
  await idle(page);
  expect((await photosOfPages(page)).map((photos) => [...photos].sort())).toEqual(
    before.map((photos) => [...photos].sort()),
  );
  for (const shown of await thumbs(page).all()) {
    const box = await shown.boundingBox();
    expect(Number(box?.width) / Number(box?.height)).toBeCloseTo(16 / 9, 1);
  }
  const removed = before.flat()[0];
  await page.getByRole('button', { name: `Remove ${removed}`, exact: true }).click({ force: true });
  await idle(page);
  expect((await photosOfPages(page)).flat()).not.toContain(removed);
});

test('the page strip shows a thumbnail of each page, and axe finds nothing', async ({ page }) => {
  await openBoard(page);
  await accessible(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('2');
  await press(page, 'Make pages from all photos');
  await expect(thumbs(page)).toHaveCount(3);
  await press(page, 'Shuffle style');
  await accessible(page);
  await expect(strip(page).locator('img[data-drawn="true"]')).toHaveCount(3);
  const drawn = await strip(page)
    .locator('img')
    .evaluateAll((list) =>
      list.map((element) => {
        const image = /** @type {HTMLImageElement} */ (element);
        const copy = document.createElement('canvas');
        [copy.width, copy.height] = [image.naturalWidth, image.naturalHeight];
        copy.getContext('2d')?.drawImage(image, 0, 0);
        return copy.toDataURL();
      }),
    );
  for (const address of drawn) expect(colours(pixelsOf(address))).toBeGreaterThan(1);
  expect(new Set(drawn).size).toBe(3);
});

/** Closes the hint that hides the button Add page. @param {Page} page */
async function leaveHint(page) {
  await page.keyboard.press('Escape');
  await expect(page.locator('.hint')).toBeEmpty();
}

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true });

  test('pages are added, opened, moved and removed', async ({ page }) => {
    await openBoard(page);
    await leaveHint(page);
    await press(page, 'Add page');
    await expect(thumbs(page)).toHaveCount(2);
    await page.getByRole('button', { name: 'Page tools' }).click();
    await accessible(page);
    await press(page, 'Move page earlier');
    await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
    const first = await picture(page);
    await thumb(page, 2).tap();
    await idle(page);
    expect(await picture(page)).not.toBe(first);
    await press(page, 'Remove page');
    await expect(thumbs(page)).toHaveCount(0);
  });

  test('a long press on a thumbnail starts a drag of the page', async ({ page }) => {
    await openBoard(page);
    await leaveHint(page);
    for (let i = 0; i < 2; i += 1) await press(page, 'Add page');
    const [from, to] = [await thumb(page, 3).boundingBox(), await thumb(page, 1).boundingBox()];
    if (!from || !to) throw new Error('no pages');
    const steps = way([from.x + from.width / 2, from.y + 20], [to.x + 4, to.y + 20]);
    await touch(page, [steps], () => expect(strip(page).locator('[data-carried="true"]')).toHaveCount(1));
    await idle(page);
    await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  });
});
