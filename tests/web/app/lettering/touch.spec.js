// @ts-check
/** Words written on the page by touch: the text stays in sight, above the keyboard of the screen too, and a second tap writes. */

import { expect, idle, openBoard, test } from '../support.js';
import { box, word } from '../word-hands.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const LONG = 'We are late again, and this is a rather long sentence that needs some lines of its own';

/** @param {Page} page */
const field = (page) => page.getByRole('textbox', { name: /^Text of/ });

/** @param {Page} page */
async function addBalloon(page) {
  await page.getByRole('button', { name: 'Words', exact: true }).tap();
  await page.getByRole('button', { name: 'Add balloon', exact: true }).tap();
  await expect(field(page)).toBeFocused();
}

/** The window that is seen, which the test makes as low as a keyboard would. @param {Page} page */
async function ownVisualViewport(page) {
  await page.addInitScript(() => {
    const seen = Object.assign(new EventTarget(), { scale: 1, offsetTop: 0, offsetLeft: 0, keyboard: 0 });
    Object.defineProperty(seen, 'height', { get: () => innerHeight - seen.keyboard });
    Object.defineProperty(seen, 'width', { get: () => innerWidth });
    Object.defineProperty(window, 'visualViewport', { value: seen });
  });
}

/** @param {Page} page @param {number} height */
const keyboard = (page, height) =>
  page.evaluate((tall) => {
    Object.assign(/** @type {any} */ (window.visualViewport), { keyboard: tall });
    window.visualViewport?.dispatchEvent(new Event('resize'));
  }, height);

for (const { viewport, tall } of [
  { viewport: { width: 390, height: 844 }, tall: 336 },
  { viewport: { width: 844, height: 390 }, tall: 200 },
]) {
  test.describe(`${viewport.width} by ${viewport.height}`, () => {
    test.use({ viewport, hasTouch: true, isMobile: true });

    test('all of a long text is in sight while it is written', async ({ page }) => {
      await openBoard(page);
      await addBalloon(page);
      await page.keyboard.type(LONG);
      const { hidden, top } = await field(page).evaluate((area) => ({
        hidden: area.scrollHeight - area.clientHeight,
        top: area.getBoundingClientRect().top,
      }));
      expect(hidden).toBeLessThanOrEqual(1);
      expect(top).toBeGreaterThanOrEqual(44);
    });

    test('what is written stays between the bar above and the keyboard', async ({ page }) => {
      await ownVisualViewport(page);
      await openBoard(page);
      await addBalloon(page);
      await page.keyboard.type('Down here');
      await page.keyboard.press('Enter');
      await idle(page);
      // To the foot of the page, where a keyboard would cover it.
      await word(page, 'Balloon: Down here').focus();
      for (let i = 0; i < 60; i += 1) await page.keyboard.press('Shift+ArrowDown');
      await idle(page);
      await page.keyboard.press('Enter');
      await expect(field(page)).toBeFocused();
      const canvas = await box(page.locator('.page-canvas'));
      await keyboard(page, tall);
      const bar = await box(page.locator('.top-bar'));
      const seen = viewport.height - tall;
      const written = async () => {
        const { y, height } = await box(field(page));
        return [y >= bar.y + bar.height, y + height <= seen];
      };
      await expect.poll(written).toEqual([true, true]);
      await page.keyboard.type(LONG.slice(0, 40));
      await expect.poll(written).toEqual([true, true]);
      // The page is as large as before, and back in its place afterwards.
      await page.keyboard.press('Escape');
      await keyboard(page, 0);
      await expect.poll(() => box(page.locator('.page-canvas'))).toEqual(canvas);
    });
  });
}

test.describe('a word under the finger', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('is chosen by a tap and written by a second one', async ({ page }) => {
    await openBoard(page);
    await addBalloon(page);
    await page.keyboard.type('Tap');
    await page.keyboard.press('Enter');
    await idle(page);
    await page.keyboard.press('Escape');
    await word(page, 'Balloon: Tap').tap();
    await expect(word(page, 'Balloon: Tap')).toHaveAttribute('aria-pressed', 'true');
    await expect(field(page)).toHaveCount(0);
    // Long after, so that it is no double tap.
    await page.waitForTimeout(900);
    await word(page, 'Balloon: Tap').tap();
    await expect(field(page)).toBeFocused();
  });

  test('has a ring of its own size', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Words', exact: true }).tap();
    await page.getByRole('button', { name: 'Add caption', exact: true }).tap();
    await expect(field(page)).toBeFocused();
    await page.keyboard.type('Soon');
    await page.keyboard.press('Enter');
    await idle(page);
    const caption = word(page, 'Caption: Soon');
    const ring = await caption.evaluate((element) => {
      const { outlineStyle, height } = getComputedStyle(element, '::before');
      return { outlineStyle, height: parseFloat(height), own: getComputedStyle(element).outlineStyle };
    });
    expect(ring).toMatchObject({ outlineStyle: 'solid', own: 'none' });
    // One line of small letters; what a finger hits is 48 pixels high.
    expect(ring.height).toBeLessThan(24);
    expect((await box(caption)).height).toBeGreaterThanOrEqual(24);
  });
});
