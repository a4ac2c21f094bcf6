// @ts-check
/** The whole job by keyboard alone, with the focus watched at every step: it is somewhere, and it is seen. */

import { readFile } from 'node:fs/promises';
import { PNG, expect, idle, picture, test } from './support.js';

/** @typedef {import('../../../www/testing.js').Page} Page */

/** What has the focus, and whether a person sees it: by its own outline, or by one drawn for it. @param {Page} page */
function focus(page) {
  return page.evaluate(() => {
    const element = /** @type {HTMLElement} */ (document.activeElement);
    const named = element.getAttribute('aria-label') ?? (/** @type {HTMLInputElement} */ (element).labels?.[0]?.innerText ?? element.innerText);
    const outlined = (/** @type {Element | null} */ of) => {
      const { outlineStyle, outlineWidth, opacity } = of ? getComputedStyle(of) : { outlineStyle: 'none', outlineWidth: '0', opacity: '0' };
      return outlineStyle !== 'none' && parseFloat(outlineWidth) >= 1 && Number(opacity) > 0;
    };
    const ring = element.matches('.panel') && document.querySelector('.panel-ring > *')?.checkVisibility({ visibilityProperty: true });
    const seen = outlined(element) || outlined(element.querySelector('.cut-grip')) || outlined(element.closest('label, li, .card')) || ring === true;
    return { tag: element.tagName, name: named?.trim() ?? '', seen };
  });
}

/**
 * Presses Tab until it is there. Each stop on the way must be seen.
 * @param {Page} page
 * @param {string | RegExp} name
 * @param {{ back?: boolean }} [how]
 */
async function tabTo(page, name, { back = false } = {}) {
  const is = (/** @type {string} */ text) => (typeof name === 'string' ? text === name : name.test(text));
  for (let i = 0; i < 160; i += 1) {
    await page.keyboard.press(back ? 'Shift+Tab' : 'Tab');
    const stop = await focus(page);
    // Past the last stop lies the browser's own bar.
    if (stop.tag === 'BODY') continue;
    expect(stop.seen, `the focus on ${stop.tag} “${stop.name}” is seen`).toBe(true);
    if (is(stop.name)) return;
  }
  throw new Error(`Tab never came to ${name}`);
}

/** @param {Page} page @param {string | RegExp} name */
async function expectFocus(page, name) {
  await expect.poll(async () => (await focus(page)).name).toMatch(typeof name === 'string' ? new RegExp(`^${name}$`) : name);
}

test('the whole job by keyboard alone', async ({ page }) => {
  test.slow();
  await page.goto('./');
  await idle(page);
  await tabTo(page, 'Try the sample album');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  await expect.poll(async () => (await focus(page)).tag, 'the start is gone, the focus is not').not.toBe('BODY');

  await test.step('shuffle and lock', async () => {
    const before = await picture(page);
    await page.keyboard.press('Space');
    await idle(page);
    expect(await picture(page) === before).toBe(false);
    await tabTo(page, 'Lock style');
    await page.keyboard.press('Enter');
    await expect(page.getByRole('button', { name: 'Lock style' })).toHaveAttribute('aria-pressed', 'true');
    await page.keyboard.press('Enter');
  });

  await test.step('a layout of four', async () => {
    await tabTo(page, 'Family');
    await page.keyboard.type('Grid');
    await tabTo(page, /./);
    await tabTo(page, /./);
    await page.keyboard.press('Home');
    while ((await focus(page)).name !== 'Four') await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    await idle(page);
  });

  await test.step('a panel: moved, enlarged, exchanged', async () => {
    await tabTo(page, 'Panel 1 of 4', { back: true });
    await page.keyboard.press('ArrowRight');
    await expectFocus(page, 'Panel 2 of 4');
    let before = await picture(page);
    for (const key of ['+', 'Enter', 'ArrowRight', 'ArrowRight', 'Enter']) await page.keyboard.press(key);
    await idle(page);
    expect(await picture(page) === before).toBe(false);
    const shown = () => page.getByRole('group', { name: /^Panel/ }).evaluateAll((list) => list.map((panel) => panel.ariaDescription?.replace(/, selected.*/, '')));
    const photos = await shown();
    before = await picture(page);
    await page.keyboard.press('Shift+Enter');
    await tabTo(page, 'Swap photo');
    await page.keyboard.press('Enter');
    await tabTo(page, 'Panel 2 of 4', { back: true });
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await idle(page);
    await expectFocus(page, 'Panel 4 of 4');
    expect(await shown()).toEqual([photos[0], photos[3], photos[2], photos[1]]);
    await page.keyboard.press('Escape');
  });

  await test.step('a cut, moved by its tools', async () => {
    await tabTo(page, 'Edit layout');
    await page.keyboard.press('Enter');
    await tabTo(page, /^Cut 1 of/, { back: true });
    const value = () => page.getByRole('slider', { name: /^Cut 1 of/ }).getAttribute('aria-valuetext');
    const before = await value();
    await tabTo(page, 'Move cut forth');
    await page.keyboard.press('Enter');
    await idle(page);
    expect(await value()).not.toBe(before);
    await tabTo(page, 'Done');
    await page.keyboard.press('Enter');
    await expect(page.getByRole('slider', { name: /^Cut 1 of/ })).toBeHidden();
    await expect.poll(async () => (await focus(page)).tag).not.toBe('BODY');
  });

  await test.step('a style', async () => {
    await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { selected: true }).focus();
    await page.keyboard.press('Home');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    await idle(page);
    expect((await focus(page)).seen).toBe(true);
  });

  await test.step('the designer, a slider, and back to where it was opened', async () => {
    await tabTo(page, 'Designer');
    await page.keyboard.press('Enter');
    await expectFocus(page, 'Style designer');
    await tabTo(page, 'Add block');
    await page.keyboard.press('Enter');
    await page.keyboard.type('Posterization');
    await page.keyboard.press('Enter');
    const slider = page.getByRole('slider', { name: 'Levels', exact: true }).last();
    await tabTo(page, 'Levels');
    const before = await slider.inputValue();
    await page.keyboard.press('ArrowRight');
    expect(await slider.inputValue()).not.toBe(before);
    await page.keyboard.press('Escape');
    await expectFocus(page, 'Designer');
  });

  await test.step('a word, written, moved and taken away', async () => {
    await tabTo(page, 'Words');
    await page.keyboard.press('Enter');
    await tabTo(page, 'Add balloon');
    await page.keyboard.press('Enter');
    await expectFocus(page, /^Text of/);
    await page.keyboard.type('By keys');
    await page.keyboard.press('Enter');
    await expectFocus(page, 'Balloon: By keys');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Delete');
    await expect(page.getByRole('button', { name: 'Balloon: By keys' })).toHaveCount(0);
    await expect.poll(async () => (await focus(page)).tag).not.toBe('BODY');
  });

  await test.step('a photo taken away: the focus goes to the next', async () => {
    await tabTo(page, /^Use /);
    await tabTo(page, /^Remove /);
    await page.keyboard.press('Enter');
    await expectFocus(page, /^(Use|Remove) /);
    await idle(page);
  });

  await test.step('the dialog of the export, and the file', async () => {
    await tabTo(page, 'Export');
    await page.keyboard.press('Enter');
    await expect(page.getByRole('dialog')).toBeVisible();
    await page.keyboard.press('Escape');
    await expectFocus(page, 'Export');
    const waiting = page.waitForEvent('download', { timeout: 60_000 });
    await page.keyboard.press('Control+s');
    expect(PNG.sync.read(await readFile(await (await waiting).path())).width).toBe(2480);
  });
});

test('letters alone can be switched off as shortcuts, and stay so', async ({ page }) => {
  await page.goto('./');
  await idle(page);
  await page.getByRole('button', { name: 'Keyboard shortcuts' }).click();
  await page.getByRole('checkbox', { name: 'Single letters are shortcuts' }).uncheck();
  await page.keyboard.press('Escape');
  await page.reload();
  await idle(page);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toHaveCount(0);
});
