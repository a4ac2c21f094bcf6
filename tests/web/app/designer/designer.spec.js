// @ts-check
/** The style designer: blocks, layers, sliders, preview and saved styles. */

import {
  FOUR,
  addBlock,
  button,
  cards,
  drawn,
  names,
  openDesigner,
  preview,
  region,
  startEmpty,
} from '../style-designer.js';
import { reloadSaved } from '../project-files.js';
import {
  accessible,
  contents,
  expect,
  idle,
  openBoard,
  picture,
  pixelsOf,
  tab,
  sharedBoardTest as test,
  reach,
} from '../support.js';

test('mouse: blocks are added, moved, bypassed, duplicated, removed and undone, and the style is used', async ({
  page,
}) => {
  await openDesigner(page);
  const plain = await preview(page);
  await addBlock(page, 'Gaussian');
  await addBlock(page, 'Posterization');
  await addBlock(page, 'XDoG', 'Foreground layer');
  expect([await names(page), await names(page, 'Foreground layer')]).toEqual([
    ['Gaussian Smoothing', 'Posterization'],
    ['XDoG', 'Soft Threshold'],
  ]);
  const built = await preview(page);
  expect(built).not.toBe(plain);

  await cards(page).nth(1).getByRole('button', { name: 'Move up' }).click();
  expect(await names(page)).toEqual(['Posterization', 'Gaussian Smoothing']);
  await expect.poll(() => preview(page)).not.toBe(built);
  await cards(page).nth(0).locator('.card-head').dragTo(cards(page).nth(1).locator('.parameter').last());
  expect(await names(page)).toEqual(['Gaussian Smoothing', 'Posterization']);
  await expect.poll(() => preview(page)).toBe(built);

  const bypass = cards(page).nth(1).getByRole('button', { name: 'Bypass' });
  await expect(bypass).toHaveAttribute('title', 'Skip this block');
  await bypass.click();
  await expect(bypass).toHaveAttribute('aria-pressed', 'true');
  await expect.poll(() => preview(page)).not.toBe(built);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(bypass).toHaveAttribute('aria-pressed', 'false');
  await expect.poll(() => preview(page)).toBe(built);

  await cards(page).first().getByRole('button', { name: 'More' }).click();
  await cards(page).first().getByRole('button', { name: 'Duplicate' }).click();
  expect(await names(page)).toEqual(['Gaussian Smoothing', 'Gaussian Smoothing', 'Posterization']);
  await cards(page).first().getByRole('button', { name: 'Remove' }).click();
  await expect.poll(() => preview(page)).toBe(built);

  const before = await picture(page);
  await button(page, 'Use').click();
  await idle(page);
  await expect(region(page)).toHaveCount(0);
  expect(await picture(page)).not.toBe(before);
  expect((await contents(page)).style).toBe('Untitled style');
});

test('blocks show plain names, and screen readers also get the technical term', async ({ page }) => {
  await openDesigner(page);
  await page.getByRole('button', { name: 'Add block' }).click();
  const palette = region(page).getByRole('region', { name: 'Blocks to add' });
  await palette.getByRole('searchbox').fill('histogram equalization');
  const found = palette.getByRole('button', { name: 'Auto levels (Linear Histogram Equalization)' });
  await expect(found).toBeVisible();
  const term = await found.getByText('Linear Histogram Equalization').boundingBox();
  expect(term?.width).toBeLessThanOrEqual(1);
});

test('the designer opens with a copy of the page style, and its lanes say what they draw', async ({ page }) => {
  await openBoard(page, FOUR);
  const { style } = await contents(page);
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  await drawn(page);
  await expect(region(page).getByRole('textbox', { name: 'Style name' })).toHaveValue(`${style} copy`);
  expect(await cards(page).count()).toBeGreaterThan(0);
  await expect(region(page).locator('.lane').getByRole('heading', { level: 3 })).toHaveText(['Colours', 'Lines']);
  // Each tool of the style has a name.
  for (const name of ['Export style', 'Import style', 'Link', 'Duplicate', 'Delete'])
    await expect(region(page).locator('.style-tools').getByText(name, { exact: true })).toBeVisible();
});

test('the names of the layers stay visible while their blocks scroll', async ({ page }) => {
  await openDesigner(page);
  for (const block of ['Blur', 'Posterization', 'Halftone', 'Brightness']) await addBlock(page, block);
  const last = cards(page).last();
  await last.scrollIntoViewIfNeeded();
  await expect(last).toBeInViewport();
  await expect(cards(page).first()).not.toBeInViewport();
  for (const name of ['Colours', 'Lines'])
    await expect(region(page).getByRole('heading', { name, exact: true })).toBeInViewport();
});

test('a slider updates the preview during a drag, and the drag is one undo step', async ({ page }) => {
  await openDesigner(page);
  await addBlock(page, 'Gaussian');
  const slider = cards(page).first().getByRole('slider', { name: 'Radius' });
  const number = cards(page).first().getByRole('spinbutton');
  const start = await preview(page);
  const box = await slider.boundingBox();
  if (!box) throw new Error('no slider');
  await page.mouse.move(box.x + 12, box.y + box.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 8; i += 1) await page.mouse.move(box.x + 12 + i * 12, box.y + box.height / 2);
  // Before the mouse button is released.
  await expect
    .poll(() =>
      region(page)
        .locator('.comparison-styled')
        .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL()),
    )
    .not.toBe(start);
  await page.mouse.up();
  const { width, height } = pixelsOf(await preview(page));
  expect(Math.max(width, height)).toBeGreaterThanOrEqual(960);
  expect(Math.min(width, height)).toBeGreaterThanOrEqual(540);
  expect(Number(await number.inputValue())).toBeGreaterThan(5);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(number).toHaveValue('2');
  await expect.poll(() => preview(page)).toBe(start);
  await number.fill('999');
  await number.press('Enter');
  await expect(number).toHaveValue('50');
  await cards(page).first().getByRole('button', { name: 'More' }).click();
  await cards(page).first().getByRole('button', { name: 'Reset' }).click();
  await expect(number).toHaveValue('2');
});

test('a block that needs gray adds To GrayScale, and an error offers to add it', async ({ page }) => {
  await openDesigner(page);
  await page.getByRole('button', { name: 'Add block' }).click();
  const palette = page.getByRole('region', { name: 'Blocks to add' });
  await expect(palette.getByRole('button', { name: /Pattern Filling/ })).toContainText('Comes with Grayscale.');
  await palette.getByRole('button', { name: /Pattern Filling/ }).click();
  expect(await names(page)).toEqual(['To GrayScale', 'Pattern Filling']);
  const drawnGray = await preview(page);
  await cards(page).first().getByRole('button', { name: 'Remove' }).click();
  await expect(cards(page).first()).toContainText('Needs gray');
  await button(page, 'Use').click();
  await expect(page.getByRole('alert')).toContainText(/background\[0\] \(pattern\): needs gray/);
  await page.getByRole('button', { name: 'Add Grayscale before it' }).click();
  await expect.poll(() => preview(page)).toBe(drawnGray);
});

test('keyboard: a style is built, saved, and edited after a reload', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Style designer', exact: true }).focus();
  await page.keyboard.press('Enter');
  await startEmpty(page);
  await page.getByRole('button', { name: 'Add block' }).focus();
  await page.keyboard.press('Enter');
  // The palette stays open for the next block, and its search is empty again.
  for (const block of ['posterization', 'saturation']) {
    await expect(page.getByRole('searchbox', { name: 'Search blocks' })).toBeFocused();
    await page.keyboard.type(block);
    await page.keyboard.press('Enter');
    await drawn(page);
  }
  await page.keyboard.press('Escape');
  await expect(page.getByRole('button', { name: 'Add block' })).toBeFocused();
  await cards(page).nth(1).focus();
  await page.keyboard.press('Alt+ArrowUp');
  expect(await names(page)).toEqual(['Saturation', 'Posterization']);
  await expect(cards(page).first()).toBeFocused();
  const slider = cards(page).first().getByRole('slider', { name: 'Amount' });
  const before = await preview(page);
  await slider.focus();
  for (let i = 0; i < 5; i += 1) await page.keyboard.press('ArrowRight');
  await expect.poll(() => preview(page)).not.toBe(before);
  await page.keyboard.press('Control+z');
  await cards(page).nth(1).focus();
  await page.keyboard.press('Delete');
  expect(await names(page)).toEqual(['Saturation']);
  await page.keyboard.press('Control+z');
  expect(await names(page)).toEqual(['Saturation', 'Posterization']);
  await page.getByLabel('Style name').focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.type('By keys');
  await button(page, 'Save style').focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('status').getByText('By keys is in My styles.')).toBeVisible();
  await reloadSaved(page);
  await tab(page, 'Styles');
  const option = page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'By keys' });
  await option.focus();
  await page.keyboard.press('Enter');
  await idle(page);
  expect((await contents(page)).style).toBe('By keys');
  await (await reach(page, 'Edit By keys')).focus();
  await page.keyboard.press('Enter');
  await expect(region(page)).toBeVisible();
  expect(await names(page)).toEqual(['Saturation', 'Posterization']);
  await page.keyboard.press('Escape');
  await expect(region(page)).toHaveCount(0);
});

test('the preview compares with the original, and shows four photos or another photo', async ({ page }) => {
  await openDesigner(page);
  await addBlock(page, 'Sobel');
  await button(page, 'Compare with original').click();
  const divider = page.getByRole('slider', { name: 'Before and after' });
  await expect(divider).toHaveAttribute('aria-valuenow', '50');
  await divider.press('PageUp');
  await expect(divider).toHaveAttribute('aria-valuenow', '60');
  const box = await region(page).locator('.comparison').boundingBox();
  if (!box) throw new Error('no preview');
  await page.mouse.move(box.x + box.width * 0.6, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  expect(Number(await divider.getAttribute('aria-valuenow'))).toBeLessThan(50);
  await button(page, 'Compare with original').click();
  await button(page, 'Four photos').click();
  await expect(region(page).locator('.comparison')).toHaveCount(4);
  await drawn(page);
  await button(page, 'Four photos').click();
  const first = await preview(page);
  // The first photo depends on the random page.
  await region(page).getByRole('group', { name: 'Preview photo' }).locator('button:not([aria-current])').last().click();
  await expect.poll(() => preview(page)).not.toBe(first);
});

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  test(`axe finds nothing in the designer, in ${colorScheme} colours`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await openDesigner(page);
    await accessible(page);
    await addBlock(page, 'Pattern');
    await addBlock(page, 'Sobel', 'Foreground layer');
    await cards(page).first().getByRole('button', { name: 'Remove' }).click();
    await button(page, 'Compare with original').click();
    await accessible(page);
    await page.getByRole('button', { name: 'Add block' }).click();
    await accessible(page);
  });
}

test('the tools of a block have their names on a large screen, also next to the palette', async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openDesigner(page);
  await addBlock(page, 'Gaussian');
  const text = cards(page).first().locator('.card-tools .icon-text').last();
  const palette = region(page).getByRole('region', { name: 'Blocks to add' });
  await expect(palette).toBeVisible();
  const fits = async () => {
    await expect(text).toBeVisible();
    const [edge, card] = await Promise.all([text.boundingBox(), cards(page).first().boundingBox()]);
    expect((edge?.x ?? 0) + (edge?.width ?? 999)).toBeLessThan((card?.x ?? 0) + (card?.width ?? 0));
  };
  await fits();
  // In a smaller window, the settings of a layer stay apart.
  await page.setViewportSize({ width: 1280, height: 720 });
  const [dark, ink] = await Promise.all(
    ['Dark paper', 'Ink colour'].map((name) => region(page).locator('.lane-setting', { hasText: name }).boundingBox()),
  );
  expect((ink?.x ?? 0) - (dark?.x ?? 0) - (dark?.width ?? 0)).toBeGreaterThanOrEqual(8);
  await palette.getByRole('button', { name: 'Close' }).click();
  await fits();
});
