// @ts-check
/** The user's own painter model: chosen, dropped, kept, missing, removed, and refused files. */

import { smallModel } from '../../../../www/engine/testing-painters.ts';
import { FOUR, addBlock, button, cards, drawn, openDesigner, preview, region } from '../style-designer.js';
import { contents, drop, expect, idle, picture, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {string} name @param {Uint8Array} [bytes] */
const model = (name, bytes = smallModel({ painters: 12 })) => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(bytes),
});

/** @param {Page} page */
const choice = (page) => cards(page).first().getByRole('group', { name: 'Model', exact: true });

/** @param {Page} page @param {{ name: string, mimeType: string, buffer: Buffer }} file */
async function chooseModel(page, file) {
  await choice(page).getByLabel('Model with painters (ONNX)').setInputFiles(file);
}

/** Opens the designer with one block Painter. @param {Page} page */
async function openPainter(page) {
  await openDesigner(page);
  await addBlock(page, 'Painter');
}

test('an own model paints previews and pages, also after a reload, and can be replaced', async ({ page }) => {
  await openPainter(page);
  const builtIn = await preview(page);
  await expect(choice(page).getByRole('button', { name: /^Use/ })).toHaveText(['Use your own model']);
  const painter = cards(page).first().getByRole('slider', { name: 'Painter' });
  await expect(painter).toHaveAttribute('max', '10');
  await chooseModel(page, model('My night.onnx'));
  await expect(choice(page).getByRole('combobox', { name: 'Model' })).toHaveValue(/^[0-9a-f]{16}$/);
  await expect(choice(page).getByRole('option', { selected: true })).toHaveText('My night.onnx');
  const own = await preview(page);
  expect(own).not.toBe(builtIn);
  // The model has twelve painters.
  await expect(painter).toHaveAttribute('max', '12');
  await cards(page)
    .first()
    .getByRole('spinbutton', { name: /^Painter/ })
    .fill('12');
  await cards(page)
    .first()
    .getByRole('spinbutton', { name: /^Painter/ })
    .press('Enter');
  const last = await preview(page);
  expect(last).not.toBe(own);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect.poll(() => preview(page)).toBe(own);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect.poll(() => preview(page)).toBe(builtIn);
  await page.getByRole('button', { name: 'Redo', exact: true }).click();
  await expect.poll(() => preview(page)).toBe(own);

  await button(page, 'Use').click();
  await idle(page);
  const painted = await picture(page);
  await expect(page.getByText('Saved', { exact: true })).toBeVisible();
  await page.reload();
  await idle(page);
  expect(await picture(page)).toBe(painted);
  await expect(page.getByRole('alert')).toHaveText('');

  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  await drawn(page);
  await expect(choice(page).getByRole('option', { selected: true })).toHaveText('My night.onnx');
  await expect.poll(() => preview(page)).toBe(own);
  await choice(page).getByRole('button', { name: 'Use the built-in painters' }).click();
  await expect.poll(() => preview(page)).toBe(builtIn);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect.poll(() => preview(page)).toBe(own);
});

test('a style without its model is drawn with the built-in painters, says so, and is complete again', async ({
  page,
}) => {
  await openPainter(page);
  await drop(page, [model('dropped.onnx')]);
  await expect(choice(page).getByRole('option', { selected: true })).toHaveText('dropped.onnx');
  const own = await preview(page);
  await button(page, 'Use').click();
  await idle(page);
  const painted = await picture(page);
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  await drawn(page);
  // Another browser has no model: its storage was cleared.
  await choice(page).getByRole('button', { name: 'Remove dropped.onnx from this browser' }).click();
  await page.getByRole('button', { name: 'Undo', exact: true }).first().click();
  await expect(choice(page)).toContainText('dropped.onnx is not in this browser. The built-in painters replace it.');
  // The message appears before the preview is drawn.
  await expect.poll(() => preview(page)).not.toBe(own);
  await page.keyboard.press('Escape');
  await expect(region(page)).toHaveCount(0);
  await idle(page);
  await expect(page.getByText('needs a painter model that is not in this browser: dropped.onnx.')).toBeVisible();
  expect(await picture(page)).not.toBe(painted);
  // The file may have another name now.
  await drop(page, [model('renamed.onnx')]);
  await expect.poll(() => picture(page)).toBe(painted);
  await expect(page.getByText('needs a painter model')).toHaveCount(0);
  expect((await contents(page)).photos).toHaveLength(FOUR.length);
});

test('files that are no models give their reason, and change nothing', async ({ page }) => {
  await openPainter(page);
  await chooseModel(page, model('mine.onnx'));
  await expect(choice(page).getByRole('option', { selected: true })).toHaveText('mine.onnx');
  const own = await preview(page);
  const noise = Uint8Array.from({ length: 3_000 }, (_, i) => (i * 7919) % 251);
  for (const [file, why] of /** @type {const} */ ([
    [model('noise.onnx', noise), 'not an ONNX file'],
    [model('large.onnx', new Uint8Array(4_200_000)), 'the limit is 4194304'],
    [model('other.onnx', smallModel({ last: 'Softmax' })), 'the operator Softmax'],
  ])) {
    await chooseModel(page, file);
    await expect(page.getByRole('alert')).toContainText(file.name);
    await expect(page.getByRole('alert')).toContainText(why);
    await page.getByRole('button', { name: 'Dismiss' }).first().click();
  }
  await expect(choice(page).getByRole('option', { selected: true })).toHaveText('mine.onnx');
  await expect.poll(() => preview(page)).toBe(own);
});
