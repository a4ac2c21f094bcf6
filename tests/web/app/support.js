// @ts-check
/**
 * What the tests share: a page that is watched for foreign requests and script errors, and the few gestures that
 * every test begins with.
 */

import { readFile } from 'node:fs/promises';
import { AxeBuilder, PNG, expect, test as plain } from '../../../www/testing.ts';

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** Photos that are no part of the site. */
const PHOTOS = new URL('../../photos/', import.meta.url);

/**
 * A test whose page made no request to another origin and threw no error, whatever else it checks.
 * @param {{ detects: boolean }} how whether the page looks for faces and objects
 */
const watched = ({ detects }) =>
  plain.extend({
    page: async ({ page, baseURL }, use) => {
      if (!detects) await page.addInitScript(() => localStorage.setItem('inkpanel.detect', 'off'));
      const { origin } = new URL(baseURL ?? '');
      /** @type {string[]} */
      const wrong = [];
      page.on('request', (request) => {
        const url = new URL(request.url());
        if (!['blob:', 'data:'].includes(url.protocol) && url.origin !== origin) wrong.push(`request to ${url}`);
      });
      page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
      page.on('console', (message) => {
        if (message.type() === 'error') wrong.push(`console: ${message.text()}`);
      });
      await use(page);
      expect(wrong).toEqual([]);
    },
  });

/** Most tests do without the detectors, which would only take time. */
export const test = watched({ detects: false });
export const detectingTest = watched({ detects: true });

export { PNG, expect };

/**
 * @param {...string} names of files in `tests/photos`
 * @returns {Promise<{ name: string, mimeType: string, buffer: Buffer }[]>}
 */
export function photos(...names) {
  return Promise.all(
    names.map(async (name) => ({ name, mimeType: 'image/jpeg', buffer: await readFile(new URL(name, PHOTOS)) })),
  );
}

/** Six photos: a page, and quick to read. */
export const SIX = ['bee.jpg', 'cat.jpg', 'crab.jpg', 'gateway.jpg', 'macaw.jpg', 'temple.jpg'];

/**
 * Until the page is drawn and its crops are final: what is found in the photos may still move them.
 * @param {Page} page
 */
export async function idle(page) {
  await page.waitForFunction(() => document.body.dataset.idle === 'true' && document.body.dataset.detected === 'true');
}

/**
 * Opens the page with some photos on the table, and waits until the page is drawn.
 * @param {Page} page
 * @param {string[]} [names]
 */
export async function openBoard(page, names = SIX) {
  await page.goto('./');
  await add(page, await photos(...names));
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
}

/**
 * @param {Page} page
 * @param {{ name: string, mimeType: string, buffer: Buffer }[]} files
 */
export async function add(page, files) {
  await page.getByLabel('Photos or video').setInputFiles(files);
}

/**
 * Drops files on the window, as a person does.
 * @param {Page} page
 * @param {{ name: string, mimeType: string, buffer: Buffer }[]} files
 * @param {{ altKey?: boolean }} [keys] held meanwhile
 */
export async function drop(page, files, keys = {}) {
  const plainFiles = files.map(({ name, mimeType, buffer }) => ({ name, mimeType, base64: buffer.toString('base64') }));
  const transfer = await page.evaluateHandle((list) => {
    const made = new DataTransfer();
    for (const { name, mimeType, base64 } of list) {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      made.items.add(new File([bytes], name, { type: mimeType }));
    }
    return made;
  }, plainFiles);
  for (const type of ['dragenter', 'dragover', 'drop'])
    await page.dispatchEvent('body', type, { dataTransfer: transfer, ...keys });
}

/**
 * Clicks, and waits until the page that follows is drawn.
 * @param {Page} page
 * @param {string} name of a button
 */
export async function press(page, name) {
  await page.getByRole('button', { name, exact: true }).click();
  await idle(page);
}

/**
 * Opens a tab beside the page; on a small screen, where there are none, nothing.
 * @param {Page} page
 * @param {'Styles' | 'Layouts' | 'Words' | 'Page'} name
 */
export async function tab(page, name) {
  const found = page.getByRole('tab', { name, exact: true });
  if (await found.isVisible()) await found.click();
}

/**
 * Takes a layout by its name.
 * @param {Page} page
 * @param {string} family
 * @param {string} name
 */
export async function choose(page, family, name) {
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Family' }).selectOption(family);
  await page.getByRole('listbox', { name: 'Layouts' }).getByRole('option', { name, exact: true }).click();
  await idle(page);
  await page.getByRole('combobox', { name: 'Family' }).selectOption('');
}

/**
 * What the page is made of, as a person can tell it: the chosen layout and style, and the photo in each panel.
 * @param {Page} page
 */
export async function contents(page) {
  // One of the lists is behind the other's tab.
  const chosen = (/** @type {string} */ name) =>
    page
      .getByRole('listbox', { name, includeHidden: true })
      .getByRole('option', { selected: true, includeHidden: true })
      .getAttribute('aria-label');
  const panels = page.getByRole('region', { name: 'Storyboard page' }).getByRole('group', { name: /^Panel \d/ });
  return {
    layout: await chosen('Layouts'),
    style: await chosen('Styles'),
    photos: await panels.evaluateAll((list) => list.map((panel) => panel.getAttribute('aria-description'))),
  };
}

/**
 * @param {Page} page
 * @returns {Promise<string>} the picture of the page on the screen
 */
export function picture(page) {
  return page.locator('.page-canvas').evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
}

/**
 * @param {string} address a data address of a PNG, as `picture` returns
 * @returns {PNG}
 */
export function pixelsOf(address) {
  return PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
}

/**
 * @param {string} a a data address of a PNG, as `picture` returns
 * @param {string} b another of the same size
 * @returns {number} how many of their pixels a person would tell apart, by their red
 */
export function different(a, b) {
  const [one, other] = [pixelsOf(a), pixelsOf(b)];
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4) if (Math.abs(one.data[i] - other.data[i]) > 24) count += 1;
  return count;
}

/**
 * @param {PNG} png
 * @returns {number} the different colours among some thousand pixels spread over it: one in a blank picture
 */
export function colours({ data }) {
  const seen = new Set();
  const step = 4 * Math.max(1, Math.floor(data.length / 4 / 5003));
  for (let i = 0; i < data.length; i += step) seen.add(data.readUInt32LE(i));
  return seen.size;
}

/**
 * Finds nothing against WCAG 2.2 AA, the size of targets included, nor against the good practices of axe.
 * @param {Page} page
 */
export async function accessible(page) {
  expect(await offences(page)).toEqual([]);
}

/**
 * What axe finds, once nothing fades in any more: it would take what is half there for pale.
 * @param {Page} page
 * @param {string[]} [only] the rules that are asked, else all
 */
export async function offences(page, only) {
  await page.evaluate(() =>
    Promise.allSettled(
      document
        .getAnimations()
        .filter(({ effect }) => Number.isFinite(effect?.getComputedTiming().endTime))
        .map(({ finished }) => finished),
    ),
  );
  // In one piece, as there is no frame of another origin: else all that is found goes through a second page, which takes
  // four times as long.
  const axe = new AxeBuilder({ page }).setLegacyMode(true);
  const rules = only ? { runOnly: only } : { rules: { 'target-size': { enabled: true } } };
  const { violations } = await axe.options({ ...rules, resultTypes: ['violations'] }).analyze();
  return violations.map(({ id, nodes }) => ({ id, nodes: nodes.map((node) => node.html.slice(0, 160)) }));
}
