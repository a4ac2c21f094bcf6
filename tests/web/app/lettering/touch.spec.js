// @ts-check
/** Text items edited by touch: the text stays visible above the on-screen keyboard, and a second tap edits. */

import { accessible, expect, idle, openBoard, test as plainTest, sharedBoardTest as test } from '../support.js';
import { box, word } from '../text-items.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const LONG = 'We are late again, and this is a rather long sentence that needs some lines of its own';

/** @param {Page} page */
const field = (page) => page.getByRole('textbox', { name: /^Text of/ });

/** @param {Page} page */
async function addBalloon(page) {
  await page.getByRole('button', { name: 'Text', exact: true }).tap();
  await page.getByRole('button', { name: 'Add balloon', exact: true }).tap();
  await expect(field(page)).toBeFocused();
}

/** Replaces the visual viewport by one whose height a test reduces, as an on-screen keyboard does. @param {Page} page */
async function replaceVisualViewport(page) {
  await page.addInitScript(() => {
    const seen = Object.assign(new EventTarget(), { scale: 1, offsetTop: 0, offsetLeft: 0, keyboard: 0 });
    Object.defineProperty(seen, 'height', { get: () => innerHeight - seen.keyboard });
    Object.defineProperty(seen, 'width', { get: () => innerWidth });
    Object.defineProperty(window, 'visualViewport', { value: seen });
  });
}

/** @param {Page} page @param {number} height */
const setKeyboardHeight = (page, height) =>
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

    plainTest('a long text and its balloon stay between the bar at the top and the keyboard', async ({ page }) => {
      await replaceVisualViewport(page);
      await openBoard(page);
      await addBalloon(page);
      await page.keyboard.type(LONG);
      const { hidden, top } = await field(page).evaluate((area) => ({
        hidden: area.scrollHeight - area.clientHeight,
        top: area.getBoundingClientRect().top,
      }));
      expect(hidden).toBeLessThanOrEqual(1);
      expect(top).toBeGreaterThanOrEqual(44);

      await page.keyboard.press('Control+a');
      await page.keyboard.type('Down here');
      await page.keyboard.press('Enter');
      await idle(page);
      // To the bottom of the page, below the on-screen keyboard.
      await word(page, 'Balloon: Down here').focus();
      for (let i = 0; i < 60; i += 1) await page.keyboard.press('Shift+ArrowDown');
      await idle(page);
      await page.keyboard.press('Enter');
      await expect(field(page)).toBeFocused();
      const canvas = await box(page.locator('.page-canvas'));
      await setKeyboardHeight(page, tall);
      const bar = await box(page.locator('.top-bar'));
      const seen = viewport.height - tall;
      const written = async () => {
        const { y, height } = await box(field(page));
        return [y >= bar.y + bar.height, y + height <= seen];
      };
      await expect.poll(written).toEqual([true, true]);
      await page.keyboard.type(LONG.slice(0, 40));
      await expect.poll(written).toEqual([true, true]);
      // Without the keyboard, the page has its size and place again.
      await page.keyboard.press('Escape');
      await setKeyboardHeight(page, 0);
      await expect.poll(() => box(page.locator('.page-canvas'))).toEqual(canvas);
    });
  });
}

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a tap selects a text item, and a second tap edits it', async ({ page }) => {
    await openBoard(page);
    await addBalloon(page);
    await page.keyboard.type('Tap');
    await page.keyboard.press('Enter');
    await idle(page);
    await page.keyboard.press('Escape');
    await word(page, 'Balloon: Tap').tap();
    await expect(word(page, 'Balloon: Tap')).toHaveAttribute('aria-pressed', 'true');
    await expect(field(page)).toHaveCount(0);
    // A double tap would edit it too, so its event is stopped.
    await page.evaluate(() => addEventListener('dblclick', (event) => event.stopImmediatePropagation(), true));
    await word(page, 'Balloon: Tap').tap();
    await expect(field(page)).toBeFocused();
  });

  test('a balloon keeps the place and the text size that its field has after typing', async ({ page }) => {
    await openBoard(page);
    for (const n of [1, 2]) {
      await page.getByRole('group', { name: new RegExp(`^Panel ${n} of`) }).tap();
      await addBalloon(page);
      await page.keyboard.type(LONG);
      const canvas = await box(page.locator('.page-canvas'));
      const seen = await box(field(page));
      const size = await field(page).evaluate((area) => Number.parseFloat(getComputedStyle(area).fontSize));
      await page.keyboard.press('Enter');
      await idle(page);
      const chosen = page.locator('.word[aria-pressed=true]');
      await expect(chosen).toHaveAccessibleName(`Balloon: ${LONG}`);
      const after = await box(chosen);
      expect(Math.abs(seen.x + seen.width / 2 - after.x - after.width / 2)).toBeLessThan(4);
      expect(Math.abs(seen.y + seen.height / 2 - after.y - after.height / 2)).toBeLessThan(4);
      await page.getByRole('button', { name: 'Format', exact: true }).tap();
      const points = Number(await page.getByRole('spinbutton', { name: 'Text size' }).inputValue());
      // A system font may be wider, and then the field reduces its text.
      expect(size).toBeLessThan((points / 72 / (2480 / 300)) * canvas.width + 0.2);
      await page.getByRole('button', { name: 'Close', exact: true }).tap();
      await page.keyboard.press('Escape');
    }
  });

  test('the tools of a selected text item have names, and Format has its shape', async ({ page }) => {
    await openBoard(page);
    await addBalloon(page);
    await page.keyboard.type('Tools');
    await page.keyboard.press('Enter');
    await idle(page);
    const tools = page.getByRole('toolbar', { name: 'Lettering tools' }).getByRole('button');
    await expect(tools).toHaveText(['Edit text', 'Format', 'Smaller text', 'Larger text', 'Remove text', 'More']);
    const rows = await tools.evaluateAll((all) => all.map((one) => one.getBoundingClientRect().top));
    expect(new Set(rows).size, 'one row').toBe(1);
    await tools.filter({ hasText: 'Format' }).tap();
    await page.getByRole('combobox', { name: 'Shape' }).selectOption('Thought');
    await idle(page);
    await accessible(page);
    await page.getByRole('button', { name: 'Close', exact: true }).tap();
    await tools.filter({ hasText: 'Remove text' }).tap();
    await expect(word(page, 'Balloon: Tools')).toHaveCount(0);
  });

  test('the outline of a selected text item has the size of its text', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Text', exact: true }).tap();
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
    // One line of small text. Its touch target is higher.
    expect(ring.height).toBeLessThan(24);
    expect((await box(caption)).height).toBeGreaterThanOrEqual(24);
  });
});

test.describe('on a narrow phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true });

  test('a balloon is added and selected by touch, and axe finds nothing', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Text', exact: true }).click();
    await accessible(page);
    await page.getByRole('button', { name: 'Add balloon' }).click();
    await expect(page.getByRole('textbox', { name: /^Text of/ })).toBeFocused();
    await page.keyboard.type('SMALL');
    await page.keyboard.press('Enter');
    await idle(page);
    const balloon = word(page, /^Balloon: SMALL/);
    await balloon.tap();
    await expect(balloon).toHaveAttribute('aria-pressed', 'true');
    await accessible(page);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  });
});
