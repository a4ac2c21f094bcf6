// @ts-check
/** Every screen on a large and on a small window: axe in both themes, and nothing that is cut off. */

import { readFile } from 'node:fs/promises';
import { lookAtScreens, openFour } from '../screens.js';
import { accessible, add, expect, idle, offences, test } from '../support.js';
import { brokenWords, cutTexts, unreachable } from '../text-checks.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** The rules of axe whose results depend on the theme. */
const COLOURS = ['color-contrast', 'link-in-text-block'];

/** The text spacing that WCAG 1.4.12 requires. */
const WIDE_TEXT =
  '* { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important } p { margin-bottom: 2em !important }';

/** Sets the text spacing with a style sheet that the Content-Security-Policy allows. @param {Page} page @param {string} css */
const setStyle = (page, css) =>
  page.evaluate((text) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    document.adoptedStyleSheets = text ? [sheet] : [];
  }, css);

/** @param {Page} page @param {number} width @param {number} height */
async function resize(page, width, height) {
  await page.setViewportSize({ width, height });
  // The page is drawn in its new size, and floating toolbars follow it.
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  await idle(page);
}

/**
 * Checks a screen in all settings, and restores the settings.
 * @param {Page} page
 * @returns {Promise<Record<string, unknown>>} the faults by check
 */
async function faults(page) {
  const { width, height } = /** @type {{ width: number, height: number }} */ (page.viewportSize());
  /** @type {Record<string, unknown[]>} */
  const found = { axe: await offences(page), text: await cutTexts(page), lost: await unreachable(page) };
  await page.emulateMedia({ colorScheme: 'dark' });
  found['axe in the dark theme'] = await offences(page, COLOURS);
  await page.emulateMedia({ colorScheme: 'light' });
  if (width >= 1000) {
    await setStyle(page, WIDE_TEXT);
    found['lost with wide text'] = await unreachable(page);
    await setStyle(page, '');
  } else {
    found['broken words'] = await brokenWords(page);
    await resize(page, 390, height);
    found['broken words at 390 pixels'] = await brokenWords(page);
    await resize(page, 320, 568);
    found['lost at 320 pixels'] = await unreachable(page);
    // A window of 1280 pixels at a zoom of 200 %.
    await resize(page, 640, 360);
    found['lost at 640 x 360'] = await unreachable(page);
    await resize(page, width, height);
  }
  return Object.fromEntries(Object.entries(found).filter(([, list]) => list.length > 0));
}

for (const use of [
  { viewport: { width: 1280, height: 800 } },
  { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2 },
]) {
  test.describe(`${use.viewport.width} wide`, () => {
    test.use(use);

    test('axe finds nothing on any screen in both themes, and nothing is cut off', async ({ page }) => {
      test.slow();
      page.setDefaultTimeout(15_000);
      /** The walk visits all screens before the test fails. @type {Record<string, unknown>} */
      const wrong = {};
      const look = async (/** @type {string} */ name) => {
        const found = await faults(page);
        if (Object.keys(found).length > 0) wrong[name] = found;
      };
      await page.goto('./');
      await idle(page);
      await look('start');
      await page.getByRole('button', { name: 'Projects' }).click();
      await look('no projects');
      await openFour(page);
      await lookAtScreens(page, look, wrong);
      expect(wrong).toEqual({});
    });
  });
}

test('axe finds nothing on a video and its time range, also while the video is read', async ({ page }) => {
  await page.goto('./');
  await add(page, [
    {
      name: 'album.mp4',
      mimeType: 'video/mp4',
      buffer: await readFile(new URL('../../../videos/album.mp4', import.meta.url)),
    },
  ]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await accessible(page);
  await idle(page);
  await page.locator('.video summary').click();
  await accessible(page);
});
