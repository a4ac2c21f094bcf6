// @ts-check
/** The page in every language: all of it in that language, and nothing cut off. */

import { STRINGS, cutWords, englishAlone, englishLeft, lookInLanguage } from './language-hands.js';
import { expect, test } from './support.js';

for (const [code, strings] of Object.entries(STRINGS)) {
  for (const [width, height] of [
    [1366, 768],
    [360, 740],
  ]) {
    test.describe(`${code} at ${width}`, () => {
      test.use({ locale: code, viewport: { width, height } });

      test('every screen is in the language, and can be read to its end', async ({ page }) => {
        test.slow();
        page.setDefaultTimeout(20_000);
        const english = englishAlone(code);
        /** @type {Record<string, string[]>} */
        const wrong = {};
        await lookInLanguage(page, strings, async (screen) => {
          const found = [
            ...(await cutWords(page)),
            ...(await englishLeft(page, english)).map((text) => `English: ${text}`),
          ];
          if (found.length > 0) wrong[screen] = found;
        });
        await expect(page.locator('html')).toHaveAttribute('lang', code);
        expect(wrong).toEqual({});
      });
    });
  }
}
