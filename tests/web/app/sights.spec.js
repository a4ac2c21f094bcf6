// @ts-check
/** The page for other eyes: much zoom, narrow windows, wide text, colours of the system, no motion. */

import { lookAtScreens, openFour } from './screens.js';
import { expect, idle, openBoard, test } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** What WCAG 1.4.12 asks a page to bear. */
const WIDE_TEXT =
  '* { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important } p { margin-bottom: 2em !important }';

/** Controls that nobody can reach by scrolling, and words that their controls cut off. @param {Page} page */
function lost(page) {
  return page.evaluate(() => {
    const wrong = [];
    const scrolls = (/** @type {Element | null} */ of, /** @type {'X' | 'Y'} */ way) => {
      for (let box = of; box && box !== document.body; box = box.parentElement) {
        if (/auto|scroll/.test(getComputedStyle(box)[`overflow${way}`])) return true;
      }
      return false;
    };
    for (const element of document.querySelectorAll(
      'button, input:not([type=file]), select, summary, textarea, [role=slider], [role=option], .panel',
    )) {
      // What lies over the board hides it; a dialog has the page to itself.
      const cover = document.querySelector('dialog[open]') ?? document.querySelector('.workspace');
      if (
        !element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) ||
        (cover && !cover.contains(element))
      )
        continue;
      const { left, right, top, bottom, width } = element.getBoundingClientRect();
      const name = element.getAttribute('aria-label') ?? element.textContent?.slice(0, 40);
      if (width === 0) continue;
      if ((right > innerWidth + 1 || left < -1) && !scrolls(element, 'X')) wrong.push(`${name}: beside the window`);
      if ((bottom > innerHeight + 1 || top < -1) && !scrolls(element, 'Y'))
        wrong.push(`${name}: above or below the window`);
      const { overflowX, textOverflow } = getComputedStyle(element);
      if (
        element.matches('button') &&
        overflowX !== 'visible' &&
        textOverflow !== 'ellipsis' &&
        element.scrollWidth > element.clientWidth + 1
      )
        wrong.push(`${name}: cut off`);
    }
    if (document.documentElement.scrollWidth > innerWidth) wrong.push('the page scrolls sideways');
    return wrong;
  });
}

/** @type {{ name: string, use: Parameters<typeof test.use>[0], css?: string }[]} */
const EYES = [
  { name: 'at 320 pixels', use: { viewport: { width: 320, height: 568 } } },
  { name: 'at 200 % of 1280', use: { viewport: { width: 640, height: 360 }, deviceScaleFactor: 2 } },
  { name: 'with wide text', use: { viewport: { width: 1280, height: 800 }, bypassCSP: true }, css: WIDE_TEXT },
];

for (const { name, use, css } of EYES) {
  test.describe(name, () => {
    test.use(use);

    test('nothing is cut off on any screen', async ({ page }) => {
      test.slow();
      page.setDefaultTimeout(15_000);
      /** @type {Record<string, unknown>} */
      const wrong = {};
      await page.goto('./');
      await idle(page);
      const look = async (/** @type {string} */ screen) => {
        const found = await lost(page);
        if (found.length > 0) wrong[screen] = found;
      };
      if (css) await page.addStyleTag({ content: css });
      await look('start');
      await openFour(page);
      if (css) await page.addStyleTag({ content: css });
      await lookAtScreens(page, look, wrong);
      expect(wrong).toEqual({});
    });
  });
}

test.describe('in Spanish', () => {
  test.use({ locale: 'es-MX' });

  test('the page speaks Spanish, as the browser does, until another language is chosen', async ({ page }) => {
    await page.goto('./');
    await idle(page);
    await expect(page.locator('html')).toHaveAttribute('lang', 'es');
    await expect(page.getByRole('button', { name: 'Probar el álbum de muestra' })).toBeVisible();
    await page.getByRole('combobox', { name: 'Idioma' }).selectOption('en');
    await expect(page.getByRole('button', { name: 'Try the sample album' })).toBeVisible();
    await expect(page.locator('html')).toHaveAttribute('lang', 'en');
    await openBoard(page);
    await page.getByRole('button', { name: 'Language and theme' }).click();
    await page.getByRole('dialog').getByRole('combobox', { name: 'Language' }).selectOption('es');
    // The work is still there.
    await expect(page.getByRole('group', { name: /^Viñeta 1 de/ })).toBeVisible();
    await idle(page);
    expect(await lost(page)).toEqual([]);
  });
});

test('English loads no word of another language', async ({ page }) => {
  /** @type {string[]} */
  const loaded = [];
  page.on('request', (request) => loaded.push(request.url()));
  await page.goto('./');
  await idle(page);
  expect(loaded.filter((url) => /\/(de|es|fr|ja|pt)-[^/]*\.js$/.test(url))).toEqual([]);
});

test.describe('without motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('nothing moves by itself', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Shuffle', exact: true }).click();
    expect(await page.evaluate(() => document.getAnimations().length)).toBe(0);
    await idle(page);
  });
});

test.describe('in the colours of the system', () => {
  test.use({ contextOptions: { forcedColors: 'active' } });

  test('what is chosen, pressed and focused is told by lines', async ({ page }) => {
    await openBoard(page);
    const line = (/** @type {string} */ selector) =>
      page
        .locator(selector)
        .first()
        .evaluate((element) => getComputedStyle(element).outlineStyle);
    await page.getByRole('button', { name: 'Lock style' }).click();
    expect(await line('[aria-pressed=true]')).toBe('solid');
    expect(await line('.option[aria-selected=true]')).toBe('solid');
    await page.locator('.panel').first().focus();
    await page.keyboard.press('ArrowRight');
    await expect(page.locator('.panel-ring > *')).toBeVisible();
  });
});
