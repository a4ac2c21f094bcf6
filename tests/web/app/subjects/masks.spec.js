// @ts-check
/** Subject masks: subjects that break the panel border, text behind subjects, and blocks for the subject only. */

import { addBlock, button, cards, drawn, preview, region, startEmpty } from '../style-designer.js';
import { savedAs } from '../export-dialog.js';
import { expectSaved } from '../project-files.js';
import {
  accessible,
  add,
  choose,
  different,
  expect,
  idle,
  openBoard,
  photos,
  picture,
  step,
  detectingTest as test,
  reach,
} from '../support.js';
import { box, inked, openWords, word, write } from '../text-items.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const MASKED = { timeout: 120_000 };

/** @param {Page} page */
const masked = (page) => expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);

/** Selects panels until a subject breaks the border of one. @param {Page} page */
async function breakOne(page) {
  const panels = page.getByRole('group', { name: /^Panel \d+ of/ });
  for (let i = 0; i < (await panels.count()); i += 1) {
    await panels.nth(i).click();
    const button = await reach(page, 'Break out of panel');
    if (await button.isDisabled()) continue;
    if ((await button.getAttribute('aria-pressed')) === 'true') return button;
    await button.click();
    if ((await button.getAttribute('aria-pressed')) === 'true') return button;
  }
  throw new Error('no subject breaks its border');
}

/** Exports the page. @param {Page} page @returns {Promise<string>} a data URL of a PNG */
async function exported(page) {
  const { bytes } = await savedAs(page, 'png');
  await page.keyboard.press('Escape');
  return `data:image/png;base64,${bytes.toString('base64')}`;
}

test('subjects break the panel border, and blocks apply to the subject or the background', async ({ page }) => {
  /** @type {string[]} */
  const nets = [];
  page.on('request', (request) => {
    if (/subject.*onnx/.test(request.url())) nets.push(request.url());
  });
  await page.goto('./');
  await add(page, await photos('macaw.jpg', 'camera.jpg', 'dahlia.jpg', 'pika.jpg'));
  await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
  // The first page does not wait for masks.
  expect(nets).toEqual([]);
  await masked(page);
  expect(nets.length).toBeGreaterThan(0);
  // No panels overlap, so each one can be clicked.
  await choose(page, 'grid', 'Four');
  await masked(page);
  await step(page, 'a subject breaks the border of its panel and returns', async () => {
    const breaks = await breakOne(page);
    await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
    const out = await picture(page);
    await breaks.click();
    await expect(breaks).toHaveAttribute('aria-pressed', 'false');
    await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
    const back = await picture(page);
    expect(different(out, back)).toBeGreaterThan(200);
    await page.getByRole('button', { name: 'Undo' }).first().click();
    await expect(page.locator('body')).toHaveAttribute('data-idle', 'true');
    expect(different(out, await picture(page))).toBe(0);
  });

  await step(page, 'a block applies to the background or the subject only, and each choice can be undone', async () => {
    await page.getByRole('button', { name: 'Style designer', exact: true }).click();
    await startEmpty(page);
    // A photo in colour: another one is grey.
    await region(page).getByRole('button', { name: 'Preview macaw.jpg' }).click();
    await drawn(page);
    await addBlock(page, 'Grayscale');
    const everywhere = await preview(page);
    const where = cards(page).first().getByRole('combobox', { name: 'Area', exact: true });
    await expect(where).toHaveValue('');
    await where.selectOption('Background');
    await expect.poll(async () => (await preview(page)) !== everywhere).toBe(true);
    const behind = await preview(page);
    await where.selectOption('Subject');
    await expect.poll(async () => [everywhere, behind].includes(await preview(page))).toBe(false);
    await accessible(page);
    const undo = page.getByRole('button', { name: 'Undo', exact: true });
    await undo.click();
    await expect.poll(async () => (await preview(page)) === behind).toBe(true);
    await undo.click();
    await expect.poll(async () => (await preview(page)) === everywhere).toBe(true);
    // The lines of a layer, with keys.
    await addBlock(page, 'XDoG', 'Foreground layer');
    const lines = await preview(page);
    const layer = region(page).getByRole('combobox', { name: 'Area of the lines' });
    await layer.focus();
    await page.keyboard.press('ArrowDown');
    await expect(layer).toHaveValue('subject');
    await expect.poll(async () => (await preview(page)) !== lines).toBe(true);
    const before = await picture(page);
    await button(page, 'Use').click();
    await idle(page);
    expect((await picture(page)) !== before).toBe(true);
  });
});

test('text items stay at their place when the mask of their photo is ready', async ({ page }) => {
  let release = () => {};
  const held = new Promise((resolve) => {
    release = () => resolve(undefined);
  });
  await page.route('**/*subject*.onnx', async (route) => {
    await held;
    await route.continue();
  });
  await openBoard(page, ['macaw.jpg']);
  await write(page, 'balloon', 'HELLO THERE');
  const balloon = word(page, /^Balloon: HELLO THERE/);
  const before = await box(balloon);
  release();
  await masked(page);
  expect(await box(balloon)).toEqual(before);
});

test('a sound effect is drawn behind the subject of its panel, on the page and in the file', async ({ page }) => {
  await openBoard(page, ['macaw.jpg']);
  await write(page, 'sound effect', 'KRAAAK');
  const behind = page.getByLabel('Behind the subject', { exact: true });
  await masked(page);
  await expect(behind).not.toBeChecked();
  for (const [label, value] of [
    ['Width', '189'],
    ['X', '105'],
    ['Y', '113'],
  ]) {
    const field = page.getByRole('spinbutton', { name: label, exact: true });
    await field.fill(value);
    await field.blur();
  }
  await idle(page);
  const before = await inked(page);
  const file = await exported(page);
  const select = async () => {
    await openWords(page);
    await word(page, /^Sound effect: /).click();
  };
  await select();
  await behind.check();
  await idle(page);
  const cut = await inked(page);
  // The bird covers a part of it.
  expect(cut.count).toBeLessThan(before.count * 0.9);
  expect(cut.count).toBeGreaterThan(before.count * 0.1);
  expect(different(file, await exported(page))).toBeGreaterThan(1000);
  await page.getByRole('button', { name: 'Undo' }).first().click();
  await idle(page);
  await select();
  await expect(behind).not.toBeChecked();
  expect((await inked(page)).count).toBe(before.count);
  await page.getByRole('button', { name: 'Redo' }).first().click();
  await expectSaved(page);
  await page.reload();
  await idle(page);
  expect((await inked(page)).count).toBe(cut.count);
});

test('without the model, the tool explains what is missing', async ({ page }) => {
  await page.route('**/*subject*.onnx', (route) => route.fulfill({ contentType: 'text/html', body: 'not here' }));
  await openBoard(page, ['macaw.jpg', 'camera.jpg', 'dahlia.jpg']);
  await expect(page.locator('body')).toHaveAttribute('data-masked', 'true', MASKED);
  await page.getByRole('group', { name: /^Panel 1 of/ }).click();
  const button = await reach(page, 'Break out of panel');
  await expect(button).toBeDisabled();
  await expect(button).toHaveAttribute('title', /[^.]: this site was built without subject detection/);
});
