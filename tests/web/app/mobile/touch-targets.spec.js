// @ts-check
/** In the hand: what a finger can hit, what a scroll leaves alone, what a phone held sideways shows. */

import { covered } from '../../covered.js';
import { drop, expect, idle, openBoard, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const SIDEWAYS = { width: 844, height: 390 };

/** Everything that is touched and that a finger 44 pixels wide would miss. @param {Page} page @returns {Promise<string[]>} */
const missed = (page) =>
  page.evaluate(() => {
    const wrong = [];
    for (const element of document.querySelectorAll('button, select, summary, textarea, input, [role=slider]')) {
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      const box = element.getBoundingClientRect();
      const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
      // What is scrolled away, and what is for the eyes of a screen reader.
      const hit = document.elementFromPoint(x, y);
      if (box.width < 2 || !hit || !(element.contains(hit) || hit.contains(element))) continue;
      // What a scroll cuts is whole after the next one.
      const cut = element.closest('.sheet-body')?.getBoundingClientRect();
      if (cut && (box.bottom > cut.bottom || box.top < cut.top)) continue;
      // A check box is hit by its label.
      const target = element.closest('label') ?? element;
      const owns = (/** @type {number} */ dx, /** @type {number} */ dy) => {
        const [px, py] = [x + dx, y + dy];
        if (px < 0 || py < 0 || px >= innerWidth || py >= innerHeight) return true;
        const there = document.elementFromPoint(px, py);
        return there !== null && (target.contains(there) || there.contains(target));
      };
      if (![owns(-20, 0), owns(20, 0), owns(0, -20), owns(0, 20)].every(Boolean))
        wrong.push(`${element.getAttribute('aria-label') ?? element.textContent} ${box.width}x${box.height}`);
    }
    return wrong;
  });

for (const viewport of [{ width: 360, height: 740 }, SIDEWAYS]) {
  test.describe(`${viewport.width} by ${viewport.height}`, () => {
    test.use({ viewport, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });

    test('nothing is too small for a finger', async ({ page }) => {
      await openBoard(page);
      // A drawer slides in and out.
      const fits = (/** @type {string} */ place) => expect.poll(() => missed(page), place).toEqual([]);
      await fits('board');
      for (const name of ['Photos', 'Styles', 'Layouts', 'Words', 'Page settings']) {
        await page.getByRole('button', { name, exact: true }).tap();
        await idle(page);
        await fits(name);
        await page.getByRole('button', { name: 'Close', exact: true }).tap();
      }
      await page.getByRole('group', { name: /^Panel 2 of/ }).tap();
      await fits('panel');
    });

    test('what is said covers nothing that can be used', async ({ page }) => {
      await openBoard(page);
      await drop(page, [{ name: 'broken.jpg', mimeType: 'image/jpeg', buffer: Buffer.from('no picture') }]);
      await expect(page.getByRole('alert').getByText('broken.jpg')).toBeVisible();
      expect(await page.evaluate(covered)).toEqual([]);
    });
  });
}

test('what is said on a large screen covers nothing that can be used', async ({ page }) => {
  await openBoard(page);
  await drop(page, [{ name: 'broken.jpg', mimeType: 'image/jpeg', buffer: Buffer.from('no picture') }]);
  await expect(page.getByRole('alert').getByText('broken.jpg')).toBeVisible();
  expect(await page.evaluate(covered)).toEqual([]);
});

test.describe('held sideways', () => {
  test.use({ viewport: SIDEWAYS, hasTouch: true, isMobile: true });

  test('the page keeps two thirds of the height, beside an open drawer too', async ({ page }) => {
    await openBoard(page);
    const size = async () => (await page.locator('.page-canvas').boundingBox()) ?? { width: 0, height: 0 };
    for (const name of ['', 'Photos', 'Styles', 'Layouts', 'Words']) {
      if (name) await page.getByRole('button', { name, exact: true }).tap();
      await idle(page);
      const { width, height } = await size();
      expect([name, width >= 200, height >= (SIDEWAYS.height * 2) / 3]).toEqual([name, true, true]);
      if (name) await page.getByRole('button', { name: 'Close', exact: true }).tap();
    }
  });
});

test.describe('a finger on a slider', () => {
  test.use({ viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true });

  test('changes it along its way, and not while it scrolls', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Page settings' }).tap();
    const slider = page.getByRole('slider', { name: 'Margin' });
    const before = await slider.inputValue();
    /** @returns {Promise<[number, number]>} a place on it that is not where it stands */
    const place = async () => {
      // The drawer slides in, and a scroll runs out by itself: until the slider stands still.
      let [y, last] = [0, -1];
      while (y !== last) {
        last = y;
        await page.waitForTimeout(150);
        y = (await slider.boundingBox())?.y ?? 0;
      }
      const box = await slider.boundingBox();
      return box ? [box.x + box.width * 0.8, box.y + box.height / 2] : [0, 0];
    };
    let [x, y] = await place();
    const client = await page.context().newCDPSession(page);
    const fingers = async (/** @type {[number, number][]} */ points) => {
      const touchPoint = (/** @type {[number, number]} */ [px, py]) => ({ x: px, y: py });
      await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [touchPoint(points[0])] });
      for (const point of points.slice(1))
        await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [touchPoint(point)] });
      await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    };
    await fingers(Array.from({ length: 12 }, (_, i) => [x, y - i * 8]));
    await idle(page);
    expect(await slider.inputValue()).toBe(before);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
    [x, y] = await place();
    await fingers(Array.from({ length: 8 }, (_, i) => [x - i * 6, y]));
    await idle(page);
    expect(await slider.inputValue()).not.toBe(before);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled();
  });
});
