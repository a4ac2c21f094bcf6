// @ts-check
/** What was covered, cut off or out of sight on small screens, by what a person does there. */

import { covered } from '../../covered.js';
import { SIX, expect, idle, openBoard, test } from '../support.js';
import { drawn, region } from '../designer-hands.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const SIDEWAYS = { width: 844, height: 390 };
const UPRIGHT = { width: 390, height: 844 };
const TABLET = { width: 820, height: 1180 };

/** More than a page holds. */
const ALBUM = [
  ...SIX,
  ...['dahlia.jpg', 'horses.jpg', 'palace.jpg', 'pika.jpg', 'raccoon.jpg', 'stream.jpg', 'wine.jpg'],
];

const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('button', { name, exact: true });

/** Whether a point in its middle belongs to it. @param {ReturnType<Page['locator']>} element */
const free = (element) =>
  element.evaluate((node) => {
    const { left, top, width, height } = node.getBoundingClientRect();
    const over = document.elementFromPoint(left + width / 2, top + height / 2);
    return over !== null && node.contains(over);
  });

/** Whether all of it is in the window. @param {ReturnType<Page['locator']>} element */
const inSight = (element) =>
  element.evaluate((node) => {
    const { left, top, right, bottom } = node.getBoundingClientRect();
    return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
  });

/** Leaves a photo out, which is told with a way back. @param {Page} page */
async function leaveOut(page) {
  await button(page, 'Photos').tap();
  await page.getByRole('checkbox', { name: 'Use bee.jpg' }).tap();
  await idle(page);
  await expect(page.getByText('bee.jpg is left out')).toBeVisible();
}

for (const viewport of [UPRIGHT, TABLET, SIDEWAYS]) {
  test.describe(`${viewport.width} by ${viewport.height}`, () => {
    test.use({ viewport, hasTouch: true, isMobile: true });

    test('the drawer of photos leaves its buttons and the bar to the finger', async ({ page }) => {
      await openBoard(page);
      await button(page, 'Photos').tap();
      await expect(button(page, 'Close')).toBeVisible();
      await expect.poll(() => free(button(page, 'Add photos'))).toBe(true);
      expect(await free(button(page, 'Close'))).toBe(true);
      expect(await free(button(page, 'Photos'))).toBe(true);
      expect(await page.evaluate(covered)).toEqual([]);
    });

    test('a note covers no tool of a panel, and none of the pages', async ({ page }) => {
      await openBoard(page, ALBUM);
      await page.getByRole('group', { name: /^Panel 2 of/ }).tap();
      await leaveOut(page);
      await button(page, 'Close').tap();
      await page.getByRole('group', { name: /^Panel 2 of/ }).tap();
      await expect(button(page, 'Lock panel')).toBeVisible();
      expect(await page.evaluate(covered)).toEqual([]);
      await page.keyboard.press('Escape');
      await button(page, 'Spread album over pages').tap();
      await idle(page);
      await expect(page.getByRole('button', { name: 'Take it back' })).toBeVisible();
      expect(await page.evaluate(covered)).toEqual([]);
      await button(page, 'Page tools').tap();
      for (const name of ['Move page earlier', 'Move page later', 'Remove page']) {
        expect([name, await inSight(button(page, name))]).toEqual([name, true]);
        expect([name, await free(button(page, name))]).toEqual([name, true]);
      }
    });

    test('tools for the photo of a panel have their names', async ({ page }) => {
      await openBoard(page);
      await page.getByRole('group', { name: /^Panel 2 of/ }).tap();
      for (const name of ['Zoom in', 'Swap', 'Star'])
        expect([name, await inSight(page.locator('.rail').getByText(name, { exact: true }))]).toEqual([name, true]);
    });
  });
}

test.describe('a note with an Undo', () => {
  test.use({ viewport: UPRIGHT, hasTouch: true, isMobile: true });

  test('goes when it would undo something else, and so does the search for a panel', async ({ page }) => {
    await openBoard(page);
    await leaveOut(page);
    await page.getByRole('button', { name: 'Choose cat.jpg' }).tap();
    await expect(page.getByText('Choose the panel for this photo')).toBeVisible();
    await page.locator('.top-bar').getByRole('button', { name: 'Undo' }).tap();
    await idle(page);
    await expect(page.getByText('bee.jpg is left out')).toHaveCount(0);
    await expect(page.getByText('Choose the panel for this photo')).toHaveCount(0);
    await expect(page.getByRole('checkbox', { name: 'Use bee.jpg' })).toBeChecked();
  });

  test('stays behind when a workspace opens over the page', async ({ page }) => {
    await openBoard(page, ALBUM);
    await button(page, 'Spread album over pages').tap();
    await expect(page.getByRole('button', { name: 'Take it back' })).toBeVisible();
    await button(page, 'Projects').tap();
    // By itself it goes later.
    await expect(page.getByRole('button', { name: 'Take it back' })).toHaveCount(0, { timeout: 3_000 });
  });
});

test.describe('held sideways', () => {
  test.use({ viewport: SIDEWAYS, hasTouch: true, isMobile: true });

  test('the designer shows the preview, two sliders and the way back at once', async ({ page }) => {
    await openBoard(page);
    await button(page, 'Styles').tap();
    await button(page, 'Designer').tap();
    await button(page, 'Add block').tap();
    await page.getByRole('searchbox', { name: 'Search blocks' }).fill('xdog');
    await page.getByRole('region', { name: 'Blocks to add' }).getByRole('listitem').getByRole('button').first().tap();
    await drawn(page);
    const sliders = region(page).locator('.parameter').getByRole('slider');
    expect([await inSight(sliders.nth(0)), await inSight(sliders.nth(1))]).toEqual([true, true]);
    const preview = await region(page).locator('.comparison-styled').first().boundingBox();
    expect(Math.min(preview?.height ?? 0, preview?.width ?? 0)).toBeGreaterThan(150);
    expect(await inSight(region(page).locator('.comparison-styled').first())).toBe(true);
    expect(await page.evaluate(covered)).toEqual([]);
    expect(await inSight(button(page, 'Use'))).toBe(true);
    await button(page, 'Back to the page').tap();
    await expect(page.locator('.page-canvas')).toBeVisible();
  });

  test('the explorer has its bar in one line, and two rows of styles', async ({ page }) => {
    await openBoard(page);
    await button(page, 'Styles').tap();
    await button(page, 'Explorer').tap();
    await button(page, 'Generate').tap();
    await expect(page.locator('.wall-item').nth(12)).toBeAttached();
    const head = await page.locator('.workspace-head').boundingBox();
    expect(head?.height).toBeLessThanOrEqual(60);
    // The filters scroll away with the wall.
    await page
      .locator('.wall-item')
      .first()
      .evaluate((item) => item.scrollIntoView({ block: 'start' }));
    const tops = await page
      .locator('.wall-item')
      .evaluateAll((items) => items.map((item) => item.getBoundingClientRect().bottom));
    expect(new Set(tops.filter((bottom) => bottom <= 390)).size).toBeGreaterThanOrEqual(2);
    await button(page, 'Back to the page').tap();
    await expect(page.locator('.page-canvas')).toBeVisible();
  });

  test('the export shows the page and the button that saves it', async ({ page }) => {
    await openBoard(page);
    await button(page, 'Export').tap();
    const dialog = page.getByRole('dialog');
    await expect(dialog.locator('canvas[data-drawn=true]')).toBeVisible();
    expect(await inSight(dialog.locator('canvas'))).toBe(true);
    expect(await inSight(dialog.getByRole('button', { name: 'Save the file' }))).toBe(true);
  });
});

test.describe('a phone held upright', () => {
  test.use({ viewport: UPRIGHT, hasTouch: true, isMobile: true });

  test('has the help in sight where its settings are', async ({ page }) => {
    await openBoard(page);
    await button(page, 'Page settings').tap();
    await expect.poll(() => inSight(button(page, 'Help and keyboard shortcuts'))).toBe(true);
    await expect.poll(() => free(button(page, 'Help and keyboard shortcuts'))).toBe(true);
    await button(page, 'Help and keyboard shortcuts').tap();
    await expect(page.getByRole('dialog').getByRole('searchbox')).toBeVisible();
  });

  test('shows two sliders of the designer below its preview', async ({ page }) => {
    await openBoard(page);
    await button(page, 'Styles').tap();
    await button(page, 'Designer').tap();
    await button(page, 'Add block').tap();
    await page.getByRole('searchbox', { name: 'Search blocks' }).fill('xdog');
    await page.getByRole('region', { name: 'Blocks to add' }).getByRole('listitem').getByRole('button').first().tap();
    await drawn(page);
    const sliders = region(page).locator('.parameter').getByRole('slider');
    expect([await inSight(sliders.nth(0)), await inSight(sliders.nth(1))]).toEqual([true, true]);
    const [save, use] = [await button(page, 'Save style').boundingBox(), await button(page, 'Use').boundingBox()];
    expect(use?.y).toBe(save?.y);
  });
});

test.describe('a laptop', () => {
  test.use({ viewport: { width: 1366, height: 768 } });

  test('tells how many photos are used in full, and leaves the tools for cuts free of notes', async ({ page }) => {
    await openBoard(page, ALBUM);
    await page.getByRole('checkbox', { name: 'Use bee.jpg' }).click({ force: true });
    await idle(page);
    const count = page.locator('.tray .count');
    await expect(count).toHaveText(/of 13/);
    expect(await count.evaluate((node) => node.scrollWidth - node.clientWidth)).toBeLessThanOrEqual(0);
    await page.getByRole('tab', { name: 'Layouts' }).click();
    await button(page, 'Edit layout').click();
    await expect(page.getByText('bee.jpg is left out')).toBeVisible();
    expect(await free(button(page, 'Done'))).toBe(true);
  });

  test('names its projects in full', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('textbox', { name: 'Project name' }).fill('Summer in the mountains with all of us');
    await page.keyboard.press('Enter');
    await button(page, 'Projects').click();
    const about = page.locator('.project-about > *');
    await expect(about.first()).toHaveText('Summer in the mountains with all of us');
    const cut = await about.evaluateAll((lines) => lines.map((line) => line.scrollWidth > line.clientWidth));
    expect(cut).toEqual([false, false]);
  });
});
