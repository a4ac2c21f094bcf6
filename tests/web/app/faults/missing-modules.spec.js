// @ts-check
/** Modules that are loaded when they are needed, and whose loading fails. */

import { fileURLToPath } from 'node:url';
import { FOUR } from '../style-designer.js';
import { chooseFormat, openExport, saved } from '../export-dialog.js';
import { expect, faultTest as test, idle, openBoard } from '../support.js';
import { openWords, word, write } from '../text-items.js';

const LETTERS = /letters-[^/]*\.bin$/;

test('text cannot be added while its fonts are missing or damaged, and can be added afterwards', async ({ page }) => {
  await openBoard(page);
  await openWords(page);
  const add = page.getByRole('button', { name: 'Add caption', exact: true });
  for (const broken of [{ status: 404, body: 'none' }, { body: 'no letters' }]) {
    await page.route(LETTERS, (route) => route.fulfill(broken));
    await add.click();
    await expect(page.getByRole('alert')).toContainText('The letters could not be loaded.');
    await page.unroute(LETTERS);
    await page.getByRole('button', { name: 'Dismiss' }).first().click();
  }
  await write(page, 'caption', 'THERE AFTER ALL');
  await expect(word(page, 'Caption: THERE AFTER ALL')).toBeVisible();
  await expect(page.getByRole('alert')).toHaveText('');
});

test('a style with a painter is drawn after its model failed to load', async ({ page }) => {
  /** @type {string[]} */
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  const model = /painters-[^/]*\.onnx$/;
  await openBoard(page);
  await page.getByRole('tab', { name: 'Styles' }).click();
  const style = page.getByRole('option', { name: 'Night Swirl' });
  await page.route(model, (route) => route.abort());
  await style.click();
  await expect(page.getByRole('alert')).toContainText('The painters could not be loaded.');
  await page.unroute(model);
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'Noir', exact: true }).click();
  await idle(page);
  await style.click();
  await idle(page);
  expect(asked.some((path) => model.test(path))).toBe(true);
  await expect(page.getByRole('alert')).toHaveText('');
});

test('a workspace opens after its script failed to load', async ({ page }) => {
  const script = /designer-screen-[^/]*\.js$/;
  await page.route(script, (route) => route.abort());
  await openBoard(page);
  const open = page.getByRole('button', { name: 'Style designer', exact: true });
  await open.click();
  await expect(page.getByRole('alert')).toContainText('This part of Inkpanel could not be loaded.');
  await page.unroute(script);
  await open.click();
  await expect(page.getByRole('region', { name: 'Style designer' })).toBeVisible();
});

test('a file format loads only its own module, and can be saved after the loading failed', async ({ page }) => {
  /** @type {string[]} */
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await openBoard(page);
  const before = asked.length;
  const format = async (/** @type {string} */ name) => {
    const dialog = await openExport(page);
    await chooseFormat(dialog, name);
    await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
    return dialog.getByRole('button', { name: 'Download' });
  };
  const modules = /inkpanel_bg-[^/]*\.wasm$/;
  await page.route(modules, (route) => route.abort());
  await (await format('jpeg')).click();
  await expect(page.getByRole('alert')).toContainText('this kind of file could not be loaded');
  await page.unroute(modules);
  const jpeg = await format('jpeg');
  expect((await saved(page, () => jpeg.click())).name).toMatch(/\.jpg$/);
  const first = asked.slice(before);
  expect(new Set(first.filter((path) => modules.test(path))).size).toBe(1);
  expect(first.filter((path) => LETTERS.test(path))).toEqual([]);
  await page.route(LETTERS, (route) => route.abort());
  await (await format('pdf')).click();
  await expect(page.getByRole('alert')).toContainText('this kind of file could not be loaded');
  await page.unroute(LETTERS);
  const pdf = await format('pdf');
  expect((await saved(page, () => pdf.click())).name).toMatch(/\.pdf$/);
  await idle(page);
});

test('the search of a style from a picture can be repeated after its module failed to load', async ({ page }) => {
  await openBoard(page, FOUR);
  const modules = /inkpanel_bg-[^/]*\.wasm$/;
  await page.route(modules, (route) => route.abort());
  await page.getByRole('button', { name: 'Style from a picture', exact: true }).click();
  const region = page.getByRole('region', { name: 'Style from a picture' });
  const print = fileURLToPath(new URL('../../../../docs/pages/noir.png', import.meta.url));
  await region.getByLabel('Picture with the style that you want').setInputFiles(print);
  await expect(region.getByText('The style search could not be loaded.', { exact: false })).toBeVisible();
  await page.unroute(modules);
  await region.getByRole('button', { name: 'Search again' }).click();
  const found = region.getByRole('list', { name: 'Styles found' }).getByRole('button');
  await expect(found.first()).toBeVisible({ timeout: 60_000 });
});
