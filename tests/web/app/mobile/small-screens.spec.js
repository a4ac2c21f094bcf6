// @ts-check
/** Small screens: no control is covered, cut off, too small for a finger or outside of the window. */

import { covered } from '../../covered.js';
import { STRINGS } from '../languages.js';
import { panel } from '../panels.js';
import { expectSaved } from '../project-files.js';
import { drawn, region, startEmpty } from '../style-designer.js';
import { SIX, drop, expect, idle, openBoard, reach, sharedBoardTest as test } from '../support.js';
import { brokenWords } from '../text-checks.js';
import { expectTouchTargets } from '../touch.js';

/** @typedef {import('../support.js').Page} Page */

const LANDSCAPE = { width: 844, height: 390 };
const PORTRAIT = { width: 390, height: 844 };
const TABLET = { width: 820, height: 1180 };

/** More photos than fit on a page. */
const ALBUM = [
  ...SIX,
  ...['dahlia.jpg', 'horses.jpg', 'palace.jpg', 'pika.jpg', 'raccoon.jpg', 'stream.jpg', 'wine.jpg'],
];

const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('button', { name, exact: true });

/** Whether nothing covers the middle of an element. @param {ReturnType<Page['locator']>} element */
const isFree = (element) =>
  element.evaluate((node) => {
    const { left, top, width, height } = node.getBoundingClientRect();
    const over = document.elementFromPoint(left + width / 2, top + height / 2);
    return over !== null && node.contains(over);
  });

/** Whether an element is completely inside of the window. @param {ReturnType<Page['locator']>} element */
const isInside = (element) =>
  element.evaluate((node) => {
    const { left, top, right, bottom } = node.getBoundingClientRect();
    return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
  });

/** Leaves a photo out, which shows a message with a button to undo. @param {Page} page */
async function leaveOut(page) {
  await button(page, 'Photos').tap();
  await page.getByRole('checkbox', { name: 'Use bee.jpg' }).tap();
  await idle(page);
  await expect(page.getByText('bee.jpg was excluded')).toBeVisible();
}

/** Checks that the alert of an unreadable file covers no control. @param {Page} page */
async function expectFreeAlert(page) {
  await drop(page, [{ name: 'broken.jpg', mimeType: 'image/jpeg', buffer: Buffer.from('no picture') }]);
  await expect(page.getByRole('alert').getByText('broken.jpg')).toBeVisible();
  expect(await page.evaluate(covered)).toEqual([]);
}

/** Opens the designer and adds a block with sliders. @param {Page} page */
async function openSliders(page) {
  await button(page, 'Menu').tap();
  await button(page, 'Style designer').tap();
  await startEmpty(page);
  await button(page, 'Add block').tap();
  await page.getByRole('searchbox', { name: 'Search blocks' }).fill('xdog');
  await page.getByRole('region', { name: 'Blocks to add' }).getByRole('listitem').getByRole('button').first().tap();
  await drawn(page);
  const sliders = region(page).locator('.parameter').getByRole('slider');
  expect([await isInside(sliders.nth(0)), await isInside(sliders.nth(1))]).toEqual([true, true]);
}

/** Checks the labels at the widths of two phones. @param {Page} page @param {string} screen */
async function expectWholeWords(page, screen) {
  for (const width of [360, PORTRAIT.width]) {
    await page.setViewportSize({ ...PORTRAIT, width });
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
    expect([screen, width, await brokenWords(page)]).toEqual([screen, width, []]);
  }
}

/** Checks at the widths of two phones that the tools of the selection are in one row, with whole labels. @param {Page} page @param {string} code */
async function expectOneRow(page, code) {
  for (const width of [360, 320]) {
    await page.setViewportSize({ width, height: 640 });
    const boxes = await page.locator('.context-bar .tool').evaluateAll((tools) =>
      tools.map((tool) => {
        const label = document.createRange();
        label.selectNodeContents(/** @type {Element} */ (tool.querySelector('span')));
        const [inner, outer] = [label, tool].map((one) => one.getBoundingClientRect());
        return { top: outer.top, isCut: inner.left < outer.left || inner.right > outer.right };
      }),
    );
    expect([code, width, boxes.some(({ isCut }) => isCut)]).toEqual([code, width, false]);
    expect([code, width, new Set(boxes.map(({ top }) => top)).size]).toEqual([code, width, 1]);
  }
}

for (const viewport of [TABLET, PORTRAIT, LANDSCAPE]) {
  test.describe(`${viewport.width} x ${viewport.height} pixels`, () => {
    test.use({ viewport, hasTouch: true, isMobile: true });

    test('the drawer of photos covers neither its buttons nor the bar', async ({ page }) => {
      await openBoard(page, ALBUM);
      await button(page, 'Photos').tap();
      await expect(button(page, 'Close')).toBeVisible();
      await expect.poll(() => isFree(button(page, 'Add photos'))).toBe(true);
      expect(await isFree(button(page, 'Close'))).toBe(true);
      expect(await isFree(button(page, 'Photos'))).toBe(true);
      expect(await page.evaluate(covered)).toEqual([]);
    });

    test('the four main tools of a panel show their names', async ({ page }) => {
      await openBoard(page, ALBUM);
      await panel(page, 2).tap();
      for (const name of ['Crop', 'Replace', 'Lock', 'Star', 'More'])
        expect([name, await isInside(page.locator('.context-bar').getByText(name, { exact: true }))]).toEqual([
          name,
          true,
        ]);
    });

    test('a message covers no tool of a panel or of the pages', async ({ page }) => {
      await openBoard(page, ALBUM);
      await panel(page, 2).tap();
      await leaveOut(page);
      await button(page, 'Close').tap();
      await panel(page, 2).tap();
      await expect(button(page, 'Lock')).toBeVisible();
      expect(await page.evaluate(covered)).toEqual([]);
      await page.keyboard.press('Escape');
      await button(page, 'Make pages from all photos').tap();
      await idle(page);
      await expect(button(page, 'Restore pages')).toBeVisible();
      expect(await page.evaluate(covered)).toEqual([]);
      await button(page, 'Page tools').tap();
      for (const name of ['Move page earlier', 'Move page later', 'Remove page']) {
        expect([name, await isInside(button(page, name))]).toEqual([name, true]);
        expect([name, await isFree(button(page, name))]).toEqual([name, true]);
      }
    });

    if (viewport === PORTRAIT) {
      test('a message with Undo disappears after another undo, as does the request to choose a panel', async ({
        page,
      }) => {
        await openBoard(page, ALBUM);
        await leaveOut(page);
        await page.getByRole('button', { name: 'Choose cat.jpg' }).tap();
        await expect(page.getByText('Select the panel for this photo')).toBeVisible();
        await page.locator('.top-bar').getByRole('button', { name: 'Undo' }).tap();
        await idle(page);
        await expect(page.getByText('bee.jpg was excluded')).toHaveCount(0);
        await expect(page.getByText('Select the panel for this photo')).toHaveCount(0);
        await expect(page.getByRole('checkbox', { name: 'Use bee.jpg' })).toBeChecked();
      });

      test('a message disappears when a workspace opens', async ({ page }) => {
        await openBoard(page, ALBUM);
        await button(page, 'Make pages from all photos').tap();
        await expect(button(page, 'Restore pages')).toBeVisible();
        await button(page, 'Projects').tap();
        await expect(page.getByRole('region', { name: 'Projects' })).toBeVisible();
        expect(await button(page, 'Restore pages').count()).toBe(0);
      });

      test('the menu shows the help', async ({ page }) => {
        await openBoard(page, ALBUM);
        await button(page, 'Menu').tap();
        await expect.poll(() => isInside(button(page, 'Help and keyboard shortcuts'))).toBe(true);
        await expect.poll(() => isFree(button(page, 'Help and keyboard shortcuts'))).toBe(true);
        await button(page, 'Help and keyboard shortcuts').tap();
        await expect(page.getByRole('dialog').getByRole('searchbox')).toBeVisible();
      });

      test('no label of a bar breaks within a word', async ({ page }) => {
        await openBoard(page, ALBUM);
        await expectWholeWords(page, 'board');
        await panel(page, 2).tap();
        await expectWholeWords(page, 'panel');
        await button(page, 'More').tap();
        await expectWholeWords(page, 'all tools of a panel');
        await button(page, 'Crop').tap();
        await expectWholeWords(page, 'crop');
        await page.keyboard.press('Escape');
        await button(page, 'Text').tap();
        await button(page, 'Add balloon').tap();
        await page.keyboard.press('Enter');
        await expectWholeWords(page, 'text');
        await button(page, 'Menu').tap();
        await button(page, 'Style designer').tap();
        await drawn(page);
        await expectWholeWords(page, 'designer');
      });

      test('the tools of a crop are in one row, with Done', async ({ page }) => {
        await openBoard(page, ALBUM);
        await panel(page, 2).tap();
        await button(page, 'Crop').tap();
        await button(page, 'Zoom in').tap();
        for (const width of [360, PORTRAIT.width]) {
          await page.setViewportSize({ ...PORTRAIT, width });
          const rows = await page
            .locator('.context-bar .tool')
            .evaluateAll((tools) => tools.map((tool) => tool.getBoundingClientRect().top));
          expect([rows.length, new Set(rows).size]).toEqual([6, 1]);
          expect(await isFree(button(page, 'Done'))).toBe(true);
        }
      });

      test('while a photo is replaced, the tray shows photos without controls', async ({ page }) => {
        await openBoard(page, ALBUM);
        await button(page, 'Photos').tap();
        const controls = page.locator('.tray .photo').getByRole('checkbox').or(page.locator('.tray .photo button'));
        await expect(controls.first()).toBeVisible();
        await button(page, 'Close').tap();
        await panel(page, 2).tap();
        await button(page, 'Replace').tap();
        await expect(page.getByRole('button', { name: 'Choose cat.jpg' })).toBeVisible();
        await expect(controls.filter({ visible: true })).toHaveCount(0);
        await page.getByRole('button', { name: 'Choose cat.jpg' }).tap();
        await expect(panel(page, 2)).toHaveAccessibleDescription(/cat\.jpg/);
      });

      test('the designer shows two sliders below the preview', async ({ page }) => {
        await openBoard(page, ALBUM);
        await openSliders(page);
        const [save, use] = [await button(page, 'Save style').boundingBox(), await button(page, 'Use').boundingBox()];
        expect(use?.y).toBe(save?.y);
      });
    }

    if (viewport === LANDSCAPE) {
      test('the designer shows the preview, two sliders and the back button', async ({ page }) => {
        await openBoard(page, ALBUM);
        await openSliders(page);
        const preview = await region(page).locator('.comparison-styled').first().boundingBox();
        expect(Math.min(preview?.height ?? 0, preview?.width ?? 0)).toBeGreaterThan(150);
        expect(await isInside(region(page).locator('.comparison-styled').first())).toBe(true);
        expect(await page.evaluate(covered)).toEqual([]);
        expect(await isInside(button(page, 'Use'))).toBe(true);
        await button(page, 'Back to the page').tap();
        await expect(page.locator('.page-canvas')).toBeVisible();
      });

      test('the explorer shows its bar in one line and two rows of styles', async ({ page }) => {
        await openBoard(page, ALBUM);
        await button(page, 'Menu').tap();
        await button(page, 'Explore styles').tap();
        await button(page, 'Generate').tap();
        await expect(page.locator('.wall-item').nth(12)).toBeAttached();
        const head = await page.locator('.workspace-head').boundingBox();
        expect(head?.height).toBeLessThanOrEqual(60);
        // The filters scroll with the styles.
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

      test('the export dialog shows the page and the save button', async ({ page }) => {
        await openBoard(page, ALBUM);
        await button(page, 'Export').tap();
        const dialog = page.getByRole('dialog');
        await expect(dialog.locator('canvas[data-drawn=true]')).toBeVisible();
        expect(await isInside(dialog.locator('canvas'))).toBe(true);
        expect(await isInside(dialog.getByRole('button', { name: 'Download' }))).toBe(true);
      });

      test('the page has two thirds of the height, also next to an open drawer', async ({ page }) => {
        await openBoard(page, ALBUM);
        const size = async () => (await page.locator('.page-canvas').boundingBox()) ?? { width: 0, height: 0 };
        for (const name of ['', 'Photos', 'Styles', 'Layouts', 'Text']) {
          if (name) await button(page, name).tap();
          await idle(page);
          const { width, height } = await size();
          expect([name, width >= 200, height >= (LANDSCAPE.height * 2) / 3]).toEqual([name, true, true]);
          if (name) await button(page, 'Close').tap();
        }
      });

      test('no control is too small for a finger, and an alert covers none', async ({ page }) => {
        await openBoard(page, ALBUM);
        await expectTouchTargets(page);
        await expectFreeAlert(page);
      });
    }
  });
}

test.describe('on a narrow phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });

  test('no control is too small for a finger, and an alert covers none', async ({ page }) => {
    await openBoard(page);
    await expectTouchTargets(page);
    await expectFreeAlert(page);
  });
});

test.describe('on the narrowest phone', () => {
  test.use({ hasTouch: true, deviceScaleFactor: 2 });

  test('the bars fit into the window in every language, also the tools of a panel and of a crop', async ({ page }) => {
    await openBoard(page);
    await expectSaved(page);
    await page.setViewportSize({ width: 320, height: 640 });
    for (const [code, { shuffle, crop, doneEditing }] of Object.entries(STRINGS)) {
      await page.evaluate((language) => localStorage.setItem('inkpanel.language', language), code);
      await page.reload();
      await expect(page.getByRole('button', { name: shuffle, exact: true })).toBeVisible();
      await idle(page);
      const outside = await page.evaluate(() =>
        [...document.querySelectorAll('.top-bar button, .parts button, .bottom-bar button, .bottom-bar span')]
          .filter((element) => element.checkVisibility())
          .filter((element) => {
            const { left, right, width } = element.getBoundingClientRect();
            return width > 1 && (left < 0 || right > innerWidth);
          })
          .map(({ textContent }) => textContent),
      );
      expect(outside, code).toEqual([]);
      await page.locator('.panel').nth(1).tap();
      await expect(button(page, crop)).toBeVisible();
      await expectOneRow(page, code);
      await button(page, crop).tap();
      await expect(button(page, doneEditing)).toBeVisible();
      await expectOneRow(page, code);
    }
  });
});

test.describe('on a laptop', () => {
  test.use({ viewport: { width: 1366, height: 768 } });

  test('the number of used photos is shown in full, and messages and alerts cover no control', async ({ page }) => {
    await openBoard(page, ALBUM);
    await page.getByRole('checkbox', { name: 'Use bee.jpg' }).click({ force: true });
    await idle(page);
    const count = page.locator('.tray .count');
    await expect(count).toHaveText(/of 13/);
    expect(await count.evaluate((node) => node.scrollWidth - node.clientWidth)).toBeLessThanOrEqual(0);
    await page.getByRole('tab', { name: 'Layouts' }).click();
    await (await reach(page, 'Edit layout')).click();
    await expect(page.getByText('bee.jpg was excluded')).toBeVisible();
    expect(await isFree(button(page, 'Done'))).toBe(true);
    await button(page, 'Done').click();
    await expectFreeAlert(page);
  });

  test('the list of projects shows the full name of a project', async ({ page }) => {
    await openBoard(page, ALBUM);
    await page.getByRole('textbox', { name: 'Project name' }).fill('Summer in the mountains with all of us');
    await page.keyboard.press('Enter');
    await button(page, 'Projects').click();
    const about = page.locator('.project-about > *');
    await expect(about.first()).toHaveText('Summer in the mountains with all of us');
    const cut = await about.evaluateAll((lines) => lines.map((line) => line.scrollWidth > line.clientWidth));
    expect(cut).toEqual([false, false]);
  });
});
