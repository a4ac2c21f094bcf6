// @ts-check
/** The whole job by keyboard alone, with the focus watched at every step: it is somewhere, and it is seen. */

import { readFile } from 'node:fs/promises';
import { four } from '../panel-hands.js';
import { expect, idle, openBoard, picture, PNG, tab, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

// What fades in on focus is there at once.
test.use({ contextOptions: { reducedMotion: 'reduce' } });

/** What has the focus, and whether a person sees it: by its own outline, or by one drawn for it. @param {Page} page */
function focus(page) {
  return page.evaluate(() => {
    const element = /** @type {HTMLElement} */ (document.activeElement);
    const named =
      element.getAttribute('aria-label') ??
      /** @type {HTMLInputElement} */ (element).labels?.[0]?.innerText ??
      element.innerText;
    const outlined = (/** @type {Element | null} */ of, /** @type {string} */ part = '') => {
      const { outlineStyle, outlineWidth, opacity } = of
        ? getComputedStyle(of, part)
        : { outlineStyle: 'none', outlineWidth: '0', opacity: '0' };
      return outlineStyle !== 'none' && parseFloat(outlineWidth) >= 1 && Number(opacity) > 0;
    };
    const ring =
      element.matches('.panel') &&
      document.querySelector('.panel-ring > *')?.checkVisibility({ visibilityProperty: true });
    const seen =
      outlined(element) ||
      (element.matches('.cut, .word') && outlined(element, '::before')) ||
      outlined(element.closest('label, li, .card')) ||
      ring === true;
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
  await expect
    .poll(async () => (await focus(page)).name)
    .toMatch(typeof name === 'string' ? new RegExp(`^${name}$`) : name);
}

/** @param {Page} page */
const expectSomewhere = (page) =>
  expect.poll(async () => (await focus(page)).tag, 'the focus is somewhere').not.toBe('BODY');

test('from the start to a page, shuffled and locked', async ({ page }) => {
  await page.goto('./');
  await idle(page);
  await tabTo(page, 'Try the sample album');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  await expectSomewhere(page);
  const before = await picture(page);
  await page.keyboard.press('Space');
  await idle(page);
  expect((await picture(page)) === before).toBe(false);
  await tabTo(page, 'Lock style');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Lock style' })).toHaveAttribute('aria-pressed', 'true');
});

test('a layout and a style are chosen', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Styles');
  await page.keyboard.press('ArrowRight');
  await expectFocus(page, 'Layouts');
  await tabTo(page, 'Family');
  await page.keyboard.type('Grid');
  await tabTo(page, 'Panels');
  await tabTo(page, /./);
  await page.keyboard.press('Home');
  for (let i = 0; i < 20 && (await focus(page)).name !== 'Four'; i += 1) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await idle(page);
  await expectFocus(page, 'Four');
  await expect(page.getByRole('group', { name: 'Panel 4 of 4' })).toBeVisible();
  await tab(page, 'Styles');
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { selected: true }).focus();
  for (const key of ['Home', 'ArrowRight', 'Enter']) await page.keyboard.press(key);
  await idle(page);
  expect((await focus(page)).seen).toBe(true);
});

test('a photo is moved, enlarged and exchanged', async ({ page }) => {
  await four(page);
  await page.getByRole('group', { name: 'Panel 1 of 4' }).focus();
  await page.keyboard.press('ArrowRight');
  await expectFocus(page, 'Panel 2 of 4');
  const before = await picture(page);
  for (const key of ['+', 'Enter', 'ArrowRight', 'ArrowRight', 'Enter']) await page.keyboard.press(key);
  await idle(page);
  expect((await picture(page)) === before).toBe(false);
  const shown = () =>
    page
      .getByRole('group', { name: /^Panel \d/ })
      .evaluateAll((list) => list.map((panel) => panel.ariaDescription?.replace(/, selected.*/, '')));
  const photos = await shown();
  await page.keyboard.press('Shift+Enter');
  await tabTo(page, 'Swap photo');
  await page.keyboard.press('Enter');
  await tabTo(page, 'Panel 2 of 4', { back: true });
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await idle(page);
  await expectFocus(page, 'Panel 4 of 4');
  expect(await shown()).toEqual([photos[0], photos[3], photos[2], photos[1]]);
});

test('a cut is moved by its tools', async ({ page }) => {
  await four(page);
  await page.getByRole('combobox', { name: 'Family' }).focus();
  await tabTo(page, 'Edit layout', { back: true });
  await page.keyboard.press('Enter');
  await tabTo(page, /^Cut 1 of/, { back: true });
  // The tools move the cut that had the focus last: on the way to them, the last one.
  const cuts = page.getByRole('slider', { name: /^Cut \d of/ });
  const places = () => cuts.evaluateAll((all) => all.map((cut) => cut.getAttribute('aria-valuetext')));
  const before = await places();
  await tabTo(page, 'Move cut forth');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect.poll(places).not.toEqual(before);
  await tabTo(page, 'Done');
  await page.keyboard.press('Enter');
  await expect(cuts).toHaveCount(0);
  await expectSomewhere(page);
});

test('a slider of the designer is moved, and the focus comes back to what opened it', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Designer');
  await page.keyboard.press('Enter');
  await expectFocus(page, 'Style designer');
  await tabTo(page, 'Add block');
  await page.keyboard.press('Enter');
  await page.keyboard.type('Posterization');
  await page.keyboard.press('Enter');
  await tabTo(page, 'Levels');
  const value = () => page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).value);
  const before = await value();
  await page.keyboard.press('ArrowRight');
  expect(await value()).not.toBe(before);
  await page.keyboard.press('Escape');
  await expectFocus(page, 'Designer');
});

test('a word is written, moved and taken away', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Styles');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await expectFocus(page, 'Words');
  await tabTo(page, 'Add balloon');
  await page.keyboard.press('Enter');
  await expectFocus(page, /^Text of/);
  await page.keyboard.type('By keys');
  await page.keyboard.press('Enter');
  await expectFocus(page, 'Balloon: By keys');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Delete');
  await expect(page.getByRole('button', { name: 'Balloon: By keys' })).toHaveCount(0);
  await expectSomewhere(page);
});

test('a photo is taken away, and the focus goes to the next', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, /^Remove .*jpg$/);
  const gone = (await focus(page)).name;
  await page.keyboard.press('Enter');
  await expectFocus(page, /^(Choose|Use|Star|Remove) .*jpg$/);
  await idle(page);
  expect((await focus(page)).name).not.toBe(gone);
});

test('the export is opened and left, and the file saved', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Export');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await expectFocus(page, 'Export');
  // The browser hides a dialog first and tells of it after; keys that come between are for nobody.
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  const waiting = page.waitForEvent('download', { timeout: 60_000 });
  await page.keyboard.press('Control+s');
  expect(PNG.sync.read(await readFile(await (await waiting).path())).width).toBe(2480);
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
