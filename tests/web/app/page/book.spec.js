// @ts-check
/** A book of all photos in one click, its text, and its undo. */

import { photosOfPages, thumb, thumbs } from '../page-strip.js';
import {
  SAMPLES,
  accessible,
  contents,
  expect,
  idle,
  openBoard,
  picture,
  press,
  tab,
  sharedBoardTest as test,
} from '../support.js';

test('one click makes a book with each photo, and Undo restores the page', async ({ page }) => {
  await openBoard(page, SAMPLES);
  const before = await picture(page);
  await expect(page.getByRole('button', { name: 'Make a book', exact: true })).toBeVisible();
  await accessible(page);
  await press(page, 'Make a book');
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  await idle(page);
  const count = await thumbs(page).count();
  expect(count).toBeGreaterThan(3);
  await accessible(page);
  const [cover, ...pages] = await photosOfPages(page);
  expect(cover).toHaveLength(1);
  const used = await page.getByRole('region', { name: 'Photos' }).getByRole('checkbox', { checked: true }).count();
  expect(new Set(pages.flat()).size).toBe(used);
  await press(page, 'Undo');
  await expect(thumbs(page)).toHaveCount(0);
  expect(await picture(page)).toBe(before);
});

test('the photo of the cover is chosen from any page of a book', async ({ page }) => {
  await openBoard(page, SAMPLES);
  // One command makes a book. The others appear with it.
  await expect(page.getByRole('button', { name: 'Choose cover photo' })).toHaveCount(0);
  await press(page, 'Make a book');
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  await thumb(page, 3).click();
  await idle(page);
  // The buttons of the book are in one place only, also among the other tools of the page.
  await page.getByRole('toolbar', { name: 'Panel tools' }).getByRole('button', { name: 'More' }).click();
  await expect(page.getByRole('button', { name: 'Choose cover photo' })).toHaveCount(1);
  await expect(page.getByRole('button', { name: 'Make a book', exact: true })).toHaveCount(1);
  await page.getByRole('region', { name: 'Pages' }).getByRole('button', { name: 'Choose cover photo' }).click();
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  await idle(page);
  const [before] = (await contents(page)).photos;
  await page
    .getByRole('region', { name: 'Photos' })
    .getByRole('button', { name: /^Choose / })
    .last()
    .click();
  await idle(page);
  expect((await contents(page)).photos).not.toEqual([before]);
  expect((await contents(page)).photos).toHaveLength(1);
});

test('a shuffle keeps the photos of a page, and the page numbers follow a move', async ({ page }) => {
  await openBoard(page, SAMPLES);
  await press(page, 'Make a book');
  await expect(thumb(page, 1)).toHaveAttribute('aria-current', 'true');
  await thumb(page, 2).click();
  await idle(page);
  const { photos } = await contents(page);
  await press(page, 'Shuffle');
  expect([...(await contents(page)).photos].sort()).toEqual([...photos].sort());
  await press(page, 'Move page later');
  await expect(thumb(page, 3)).toHaveAttribute('aria-current', 'true');
  await expect(page.getByRole('button', { name: 'Page number: 3', exact: true })).toBeVisible();
  await tab(page, 'Text');
  const texts = page.getByRole('list', { name: 'Text on the page' });
  await expect(texts.getByRole('button', { name: 'Page number: 3', exact: true })).toBeVisible();
});
