// @ts-check
/** The app in other languages: all texts are translated, and no text is cut off. */

import { LONGEST, STRINGS, englishLeft, lookInLanguage, onlyEnglish, speakLongest } from '../languages.js';
import { expect, idle, openBoard, test } from '../support.js';
import { brokenWords, cutTexts, unreachable } from '../text-checks.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */
/** @typedef {import('../languages.js').Strings} Strings */

const SIZES = /** @type {const} */ ([
  [1366, 768],
  [360, 740],
]);

/**
 * Visits all screens. The test fails after the last one.
 * @param {Page} page
 * @param {string} code of the language
 * @param {Strings} strings
 */
async function checkScreens(page, code, strings) {
  test.slow();
  page.setDefaultTimeout(20_000);
  const english = onlyEnglish(strings);
  /** @type {Record<string, string[]>} */
  const wrong = {};
  await lookInLanguage(page, strings, async (screen) => {
    const found = [
      ...(await cutTexts(page)),
      ...(await brokenWords(page)).map((text) => `broken: ${text}`),
      ...(await englishLeft(page, english)).map((text) => `English: ${text}`),
    ];
    if (found.length > 0) wrong[screen] = found;
  });
  await expect(page.locator('html')).toHaveAttribute('lang', code);
  expect(wrong).toEqual({});
}

for (const [width, height] of SIZES) {
  test.describe(`longest translations at ${width}`, () => {
    test.use({ locale: LONGEST.code, viewport: { width, height } });

    test('all texts of all screens are translated, and none is cut off', async ({ page }) => {
      await speakLongest(page);
      await checkScreens(page, LONGEST.code, LONGEST.strings);
    });
  });

  for (const [code, strings] of Object.entries(STRINGS)) {
    test.describe(`${code} at ${width}`, { tag: '@nightly' }, () => {
      test.use({ locale: code, viewport: { width, height } });

      test('all texts of all screens are translated, and none is cut off', ({ page }) =>
        checkScreens(page, code, strings));
    });
  }
}

test.describe('in Spanish', () => {
  test.use({ locale: 'es-MX' });

  test('the app uses the language of the browser until the user selects another one', async ({ page }) => {
    await page.goto('./');
    await idle(page);
    await expect(page.locator('html')).toHaveAttribute('lang', 'es');
    await expect(page.getByRole('button', { name: STRINGS.es.trySamples })).toBeVisible();
    await page.getByRole('combobox', { name: STRINGS.es.language }).selectOption('en');
    await expect(page.getByRole('button', { name: STRINGS.en.trySamples })).toBeVisible();
    await expect(page.locator('html')).toHaveAttribute('lang', 'en');
    await openBoard(page);
    await page.getByRole('button', { name: 'Menu' }).click();
    await page.getByRole('dialog').getByRole('combobox', { name: 'Language' }).selectOption('es');
    // The project is still open.
    await expect(page.getByRole('group', { name: /^Viñeta 1 de/ })).toBeVisible();
    await idle(page);
    expect(await unreachable(page)).toEqual([]);
  });
});

test('English loads no file of another language', async ({ page }) => {
  /** @type {string[]} */
  const loaded = [];
  page.on('request', (request) => loaded.push(request.url()));
  await page.goto('./');
  await idle(page);
  expect(loaded.filter((url) => /\/(de|es|fr|ja|pt)-[^/]*\.js$/.test(url))).toEqual([]);
});
