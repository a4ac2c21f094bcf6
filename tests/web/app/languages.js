// @ts-check
/** The languages of the app, the screens by the texts of a language, and checks of these texts. */

import { readdirSync, readFileSync } from 'node:fs';
import { compose } from '../../../www/strings/compose.ts';
import * as de from '../../../www/strings/compiled/de.ts';
import * as en from '../../../www/strings/compiled/en.ts';
import * as es from '../../../www/strings/compiled/es.ts';
import * as fr from '../../../www/strings/compiled/fr.ts';
import * as ja from '../../../www/strings/compiled/ja.ts';
import * as pt from '../../../www/strings/compiled/pt.ts';
import { expect, idle, photos, reach } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {ReturnType<typeof compose>} Strings */

const TRANSLATIONS = { de, es, fr, ja, pt };

/** All texts of the app, by the code of the language. @type {Record<string, Strings>} */
export const STRINGS = Object.fromEntries(
  Object.entries({ en, ...TRANSLATIONS }).map(([code, translation]) => [code, compose(code, translation)]),
);

/**
 * Returns the longest of several translations of a text. The result of functions, lists and groups consists of the longest
 * texts. The function also runs in the browser, so it uses nothing from this module.
 * @param {any[]} translations
 * @returns {any}
 */
function longest(translations) {
  const known = translations.filter((value) => value !== undefined);
  const [first] = known;
  if (typeof first === 'function') return (/** @type {any[]} */ ...given) => longest(known.map((of) => of(...given)));
  if (Array.isArray(first))
    return Array.from({ length: Math.max(...known.map((list) => list.length)) }, (_, i) =>
      longest(known.map((list) => list[i])),
    );
  if (typeof first === 'object' && first !== null) {
    const keys = new Set(known.flatMap(Object.keys));
    return Object.fromEntries([...keys].map((key) => [key, longest(known.map((group) => group[key]))]));
  }
  if (typeof first !== 'string') return first;
  // Japanese characters are twice as wide as Latin letters.
  const width = (/** @type {string} */ text) => [...text].reduce((sum, sign) => sum + (sign > '\u2e80' ? 2 : 1), 0);
  return known.reduce((best, text) => (width(text) > width(best) ? text : best));
}

/** A pseudo-language of the longest translation of each text. It replaces German. */
export const LONGEST = {
  code: 'de',
  strings: compose('de', longest(Object.values(TRANSLATIONS).map(({ names, messages }) => ({ names, messages })))),
};

/** Makes the app use the pseudo-language if its language is German. @param {Page} page */
export async function speakLongest(page) {
  const files = readdirSync(new URL('../../../www/dist/assets/', import.meta.url));
  const codes = Object.keys(TRANSLATIONS);
  // The texts of the help are separate modules.
  for (const area of ['', 'help-']) {
    const file = (/** @type {string} */ code) =>
      String(files.find((name) => new RegExp(`^${area}${code}-[\\w-]{8}\\.js$`).test(name)));
    await page.route(`**/assets/${file(LONGEST.code)}`, (route) =>
      route.fulfill({
        contentType: 'text/javascript',
        body: `${codes.map((code) => `import * as ${code} from './${file(code)}${code === LONGEST.code ? '?translation' : ''}';`).join('\n')}
${longest}
const all = [${codes}];
export const messages = longest(all.map(({ messages }) => messages));
export const names = longest(all.map(({ names }) => names));
`,
      }),
    );
  }
}

/** @param {string} folder next to `www` @returns {{ id: string, name: string }[]} */
function dataOf(folder) {
  const url = new URL(`../../../${folder}/`, import.meta.url);
  return readdirSync(url)
    .filter((name) => name.endsWith('.json'))
    .map((name) => JSON.parse(readFileSync(new URL(name, url), 'utf8')));
}

/** @param {unknown} value @returns {string[]} all texts in it */
function textsOf(value) {
  if (typeof value === 'string') return [value];
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(textsOf) : [];
}

/** Returns the texts that are English in the app and different in another language. @param {Strings} strings of the language */
export function onlyEnglish(strings) {
  const { styleTitle, layoutTitle } = strings;
  const said = (/** @type {Strings} */ all) => [
    ...textsOf(all),
    ...dataOf('styles').map(all.styleTitle),
    ...dataOf('layouts').map(all.layoutTitle),
  ];
  // Names without a translation are English.
  const kept = [
    ...dataOf('styles').filter((style) => styleTitle({ ...style, name: '' }) === ''),
    ...dataOf('layouts').filter((layout) => layoutTitle({ ...layout, name: '' }) === ''),
  ].map(({ name }) => name);
  const own = new Set([...said(strings), ...kept]);
  return [...new Set(said(STRINGS.en))].filter((text) => text.length > 1 && !own.has(text));
}

const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('button', { name, exact: true });

/** Opens a drawer of a small screen, or a tab of a large one. @param {Page} page @param {string} drawer @param {string} tab */
async function side(page, drawer, tab) {
  if (await button(page, drawer).isVisible()) await button(page, drawer).click();
  else await page.getByRole('tab', { name: tab, exact: true }).click();
}

/** Opens a view, which is in the menu of a small screen. @param {Page} page @param {Strings} strings @param {string} name */
async function work(page, strings, name) {
  if (!(await button(page, name).isVisible())) await button(page, strings.menu).click();
  await button(page, name).click();
}

/** @type {Record<string, (page: Page, strings: Strings) => Promise<void>>} */
const SCREENS = {
  board: async () => {},
  'a panel is chosen': (page) => page.locator('.panel').last().click(),
  'all tools of a panel': async (page, strings) => {
    await page.locator('.panel').last().click();
    await reach(page, strings.saveSubject);
  },
  styles: async (page, strings) => {
    await side(page, strings.styles, strings.sideTab.styles);
    await (await reach(page, strings.styleShuffle)).click();
  },
  layouts: (page, strings) => side(page, strings.layouts, strings.sideTab.layouts),
  'cuts of the layout': async (page, strings) => {
    await side(page, strings.layouts, strings.sideTab.layouts);
    await (await reach(page, strings.editLayout)).click();
  },
  words: async (page, strings) => {
    await side(page, strings.words, strings.sideTab.words);
    await button(page, strings.addWord.balloon).click();
    await expect(page.locator('.word-editor')).toBeFocused();
    await page.keyboard.press('Enter');
  },
  'page settings': async (page, strings) => {
    if (await page.getByRole('tab').first().isVisible()) await side(page, strings.pageSettings, strings.sideTab.page);
    else await work(page, strings, strings.pageSettings);
    await page.getByRole('combobox', { name: strings.pageSize }).selectOption('custom');
  },
  photos: async (page, strings) => {
    if (await button(page, strings.photos).isVisible()) await button(page, strings.photos).click();
    await page.locator('.photo-choice summary').click();
  },
  designer: async (page, strings) => {
    await work(page, strings, strings.designer);
    await expect(page.getByRole('region', { name: strings.preview, exact: true })).toHaveAttribute(
      'aria-busy',
      'false',
    );
  },
  'blocks of the designer': async (page, strings) => {
    await work(page, strings, strings.designer);
    await button(page, strings.addBlock).click();
  },
  explorer: async (page, strings) => {
    await work(page, strings, strings.explorer);
    await button(page, strings.generate).click();
    await expect(page.locator('.wall-item').nth(3)).toBeVisible();
    await expect(button(page, strings.generate)).toBeVisible({ timeout: 180_000 });
  },
  projects: (page, strings) => button(page, strings.projects).click(),
  export: (page, strings) => button(page, strings.export).click(),
  help: async (page) => {
    await page.keyboard.press('?');
    await expect(page.getByRole('dialog')).toBeVisible();
  },
};

/**
 * Visits the start and all screens of a board of four photos.
 * @param {Page} page
 * @param {Strings} strings of the language of the app
 * @param {(screen: string) => Promise<void>} look
 */
export async function lookInLanguage(page, strings, look) {
  await page.goto('./');
  await idle(page);
  await look('start');
  await page
    .getByLabel(strings.filesLabel)
    .setInputFiles(await photos('bee.jpg', 'cat.jpg', 'gateway.jpg', 'macaw.jpg'));
  await expect(page.getByRole('region', { name: strings.page })).toBeVisible();
  await idle(page);
  for (const [name, open] of Object.entries(SCREENS)) {
    await open(page, strings);
    await look(name);
    for (let i = 0; i < 5; i += 1) {
      await page.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
      await page.keyboard.press('Escape');
    }
    for (const dismiss of await button(page, strings.dismiss).all()) await dismiss.click();
    // The app ignores keys until the dialog is removed.
    await expect(page.locator('dialog')).toHaveCount(0);
  }
}

/**
 * Returns English texts on the screen and in accessible names.
 * @param {Page} page
 * @param {string[]} english
 */
export function englishLeft(page, english) {
  return page.evaluate((list) => {
    const known = new Set(list);
    const said = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node instanceof Element) {
        // Generated styles have English names.
        if (node.matches('noscript, [lang], .wall-item')) continue;
        for (const name of ['aria-label', 'aria-description', 'title', 'placeholder', 'aria-valuetext'])
          said.push(node.getAttribute(name) ?? '');
      } else if (!node.parentElement?.closest('noscript, script, [lang]:not(html)')) said.push(node.textContent ?? '');
    }
    return [...new Set(said.map((text) => text.trim()).filter((text) => known.has(text)))];
  }, english);
}
