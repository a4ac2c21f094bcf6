// @ts-check
/** Every screen in every language: the way there by the words of the language, and what is wrong with the words there. */

import { readdirSync, readFileSync } from 'node:fs';
import { compose } from '../../../www/strings/compose.ts';
import * as de from '../../../www/strings/de/index.ts';
import * as en from '../../../www/strings/en/index.ts';
import * as es from '../../../www/strings/es/index.ts';
import * as fr from '../../../www/strings/fr/index.ts';
import * as ja from '../../../www/strings/ja/index.ts';
import * as pt from '../../../www/strings/pt/index.ts';
import { expect, idle, photos } from './support.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {ReturnType<typeof compose>} Strings */

const TRANSLATIONS = { en, de, es, fr, pt, ja };

/** Everything that the page says, by the code of the language. @type {Record<string, Strings>} */
export const STRINGS = Object.fromEntries(
  Object.entries(TRANSLATIONS).map(([code, translation]) => [code, compose(code, translation)]),
);

/** @param {string} folder beside `www` @returns {{ id: string, name: string }[]} */
function dataOf(folder) {
  const url = new URL(`../../../${folder}/`, import.meta.url);
  return readdirSync(url)
    .filter((name) => name.endsWith('.json'))
    .map((name) => JSON.parse(readFileSync(new URL(name, url), 'utf8')));
}

/** @param {unknown} value @returns {string[]} every text below */
function textsOf(value) {
  if (typeof value === 'string') return [value];
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(textsOf) : [];
}

/** @param {string} code @returns {string[]} what only English says */
export function englishAlone(code) {
  const { styleTitle, layoutTitle } = STRINGS[code];
  const said = (/** @type {Strings} */ strings) => [
    ...textsOf(strings),
    ...dataOf('styles').map(strings.styleTitle),
    ...dataOf('layouts').map(strings.layoutTitle),
  ];
  // What a language has no name for is English.
  const kept = [
    ...dataOf('styles').filter((style) => styleTitle({ ...style, name: '' }) === ''),
    ...dataOf('layouts').filter((layout) => layoutTitle({ ...layout, name: '' }) === ''),
  ].map(({ name }) => name);
  const own = new Set([...said(STRINGS[code]), ...kept]);
  return [...new Set(said(STRINGS.en))].filter((text) => text.length > 1 && !own.has(text));
}

const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('button', { name, exact: true });

/** Opens a drawer of a small screen, or a tab of a large one. @param {Page} page @param {string} drawer @param {string} tab */
async function side(page, drawer, tab) {
  if (await button(page, drawer).isVisible()) await button(page, drawer).click();
  else await page.getByRole('tab', { name: tab, exact: true }).click();
}

/** Into the workspaces, whose buttons are among the styles on a small screen. @param {Page} page @param {Strings} strings @param {string} name */
async function work(page, strings, name) {
  if (!(await button(page, name).isVisible())) await button(page, strings.styles).click();
  await button(page, name).click();
}

/** @type {Record<string, (page: Page, strings: Strings) => Promise<void>>} */
const SCREENS = {
  board: async () => {},
  'a panel is chosen': (page) => page.locator('.panel').last().click(),
  styles: async (page, strings) => {
    await side(page, strings.styles, strings.sideTab.styles);
    await button(page, strings.styleShuffle).click();
  },
  layouts: (page, strings) => side(page, strings.layouts, strings.sideTab.layouts),
  'cuts of the layout': async (page, strings) => {
    await side(page, strings.layouts, strings.sideTab.layouts);
    await button(page, strings.editLayout).click();
  },
  words: async (page, strings) => {
    await side(page, strings.words, strings.sideTab.words);
    await button(page, strings.addWord.balloon).click();
    await expect(page.locator('.word-editor')).toBeFocused();
    await page.keyboard.press('Enter');
  },
  'page settings': async (page, strings) => {
    await side(page, strings.pageSettings, strings.sideTab.page);
    await page.getByRole('combobox', { name: strings.pageSize }).selectOption('custom');
  },
  photos: async (page, strings) => {
    if (await button(page, strings.photos).isVisible()) await button(page, strings.photos).click();
    await page.locator('.choice summary').click();
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
    await expect(button(page, strings.generate)).toBeVisible({ timeout: 60_000 });
  },
  projects: (page, strings) => button(page, strings.projects).click(),
  export: (page, strings) => button(page, strings.export).click(),
  help: async (page) => {
    await page.keyboard.press('?');
    await expect(page.getByRole('dialog')).toBeVisible();
  },
};

/**
 * Goes through the start and all screens of a board of four photos.
 * @param {Page} page
 * @param {Strings} strings of the language that the page speaks
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
    // A dialog tells that it was closed a moment later, and no key is heard before that.
    await expect(page.locator('dialog')).toHaveCount(0);
  }
}

/**
 * Words that cannot be read to their end, as a box around them cuts them off or they reach out of their control; what
 * scrolls can be read. Names of files and projects are as long as people make them.
 * @param {Page} page
 */
export function cutWords(page) {
  return page.evaluate(() => {
    /** @type {string[]} */
    const wrong = [];
    const OWN = '.photo-name, .project-about, .stack-name, .project-name, [data-own-name]';
    const cover = document.querySelector('dialog[open]') ?? document.querySelector('.workspace');
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const element = /** @type {HTMLElement} */ (node.parentElement);
      const text = (node.textContent ?? '').trim();
      if (text === '' || element.closest('script, style, noscript, option, .visually-hidden') || element.closest(OWN))
        continue;
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      if (cover && !cover.contains(element)) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const words = range.getBoundingClientRect();
      // What is there for screen readers alone is a pixel wide.
      if (words.width === 0 || element.clientWidth === 1) continue;
      // Half a pixel more or less is rounding.
      const beyond = (/** @type {DOMRect} */ box, /** @type {boolean} */ across, /** @type {boolean} */ along) =>
        (across && (words.right > box.right + 1.5 || words.left < box.left - 1.5)) ||
        (along && (words.bottom > box.bottom + 4 || words.top < box.top - 4));
      const control = element.closest('button, summary, [role=option], [role=tab], .chip, .toast');
      if (control && beyond(control.getBoundingClientRect(), true, true))
        wrong.push(`${text}: reaches out of its control`);
      let [across, along] = [true, true];
      for (
        let box = element;
        box && box !== document.documentElement;
        box = /** @type {HTMLElement} */ (box.parentElement)
      ) {
        const { overflowX, overflowY } = getComputedStyle(box);
        // What can be scrolled to can be read.
        if (/auto|scroll/.test(overflowX)) across = false;
        if (/auto|scroll/.test(overflowY)) along = false;
        const [clipsX, clipsY] = [/hidden|clip/.test(overflowX), /hidden|clip/.test(overflowY)];
        if (beyond(box.getBoundingClientRect(), across && clipsX, along && clipsY)) {
          wrong.push(`${text}: cut off by ${box.className || box.tagName}`);
          break;
        }
        if (getComputedStyle(box).position === 'fixed') break;
      }
    }
    const pen = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
    for (const field of document.querySelectorAll('select, input[placeholder], input[type=number]')) {
      if (!field.checkVisibility({ visibilityProperty: true }) || (cover && !cover.contains(field))) continue;
      const { font, paddingLeft, paddingRight } = getComputedStyle(field);
      // One that begins with what cannot be chosen is a menu, and never shows the rest.
      const texts =
        field instanceof HTMLSelectElement
          ? [...field.options].slice(0, field.options[0]?.disabled ? 1 : undefined).map(({ text }) => text)
          : // A name of a person's own may have any length where its title tells it in full.
            [
              /** @type {HTMLInputElement} */ (field).placeholder,
              ...[/** @type {HTMLInputElement} */ (field).value].filter(
                (value) => value !== field.getAttribute('title'),
              ),
            ];
      pen.font = font;
      const room = field.clientWidth - Number.parseFloat(paddingLeft) - Number.parseFloat(paddingRight);
      // The browser keeps some for its marks.
      const { appearance } = getComputedStyle(field);
      const mark =
        appearance === 'textfield'
          ? 0
          : field instanceof HTMLSelectElement
            ? 20
            : field.matches('[type=number]')
              ? 15
              : 0;
      for (const text of texts) {
        const over = Math.round(pen.measureText(text).width - (room - mark));
        if (over > 1) wrong.push(`${text}: ${over} pixels too long for its field`);
      }
    }
    // What is made to scroll down is not made to scroll sideways.
    for (const box of document.querySelectorAll('.side-panel > *, .sheet-body, .tray, .lanes, .wall, .listbox, dialog'))
      if (box.checkVisibility({ visibilityProperty: true }) && box.scrollWidth > box.clientWidth + 1)
        wrong.push(`${box.className}: scrolls sideways by ${box.scrollWidth - box.clientWidth}`);
    if (document.documentElement.scrollWidth > innerWidth) wrong.push('the page scrolls sideways');
    return [...new Set(wrong)];
  });
}

/**
 * What is said in English though the language has words of its own for it, seen or told.
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
        // The core calls what it invents in English.
        if (node.matches('noscript, [lang], .wall-item')) continue;
        for (const name of ['aria-label', 'aria-description', 'title', 'placeholder', 'aria-valuetext'])
          said.push(node.getAttribute(name) ?? '');
      } else if (!node.parentElement?.closest('noscript, script, [lang]:not(html)')) said.push(node.textContent ?? '');
    }
    return [...new Set(said.map((text) => text.trim()).filter((text) => known.has(text)))];
  }, english);
}
