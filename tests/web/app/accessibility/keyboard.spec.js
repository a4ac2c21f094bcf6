// @ts-check
/** Every task by keyboard, with a visible focus at each step, and the shortcuts. */

import { saved } from '../export-dialog.js';
import { four } from '../panels.js';
import { startEmpty } from '../style-designer.js';
import {
  contents,
  expect,
  idle,
  openBoard,
  openStart,
  picture,
  PNG,
  tab,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

// Elements that fade in on focus are visible at once.
test.use({ contextOptions: { reducedMotion: 'reduce' } });

/** Returns the focused element, and whether its focus is visible by its outline or by a separate one. @param {Page} page */
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
 * Presses Tab until an element has the focus. Each focus on the way must be visible.
 * @param {Page} page
 * @param {string | RegExp} name
 * @param {{ back?: boolean }} [how]
 */
async function tabTo(page, name, { back = false } = {}) {
  const is = (/** @type {string} */ text) => (typeof name === 'string' ? text === name : name.test(text));
  for (let i = 0; i < 160; i += 1) {
    await page.keyboard.press(back ? 'Shift+Tab' : 'Tab');
    const stop = await focus(page);
    // After the last element, the browser has the focus.
    if (stop.tag === 'BODY') continue;
    expect(stop.seen, `the focus on ${stop.tag} “${stop.name}” is visible`).toBe(true);
    if (is(stop.name)) return;
  }
  throw new Error(`Tab did not reach ${name}`);
}

/** @param {Page} page @param {string | RegExp} name */
async function expectFocus(page, name) {
  await expect
    .poll(async () => (await focus(page)).name)
    .toMatch(typeof name === 'string' ? new RegExp(`^${name}$`) : name);
}

/** @param {Page} page */
const expectAnyFocus = (page) =>
  expect.poll(async () => (await focus(page)).tag, 'an element has the focus').not.toBe('BODY');

test('the sample album is opened, shuffled, undone and locked', async ({ page }) => {
  await openStart(page);
  await idle(page);
  await tabTo(page, 'Try the sample album');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await expectAnyFocus(page);
  const first = await picture(page);
  await page.keyboard.press('Space');
  await idle(page);
  expect(await picture(page)).not.toBe(first);
  await page.keyboard.press('Control+z');
  await idle(page);
  expect(await picture(page)).toBe(first);
  await page.keyboard.press('Shift+Control+Z');
  await idle(page);
  expect(await picture(page)).not.toBe(first);
  await tabTo(page, 'Lock style');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Lock style' })).toHaveAttribute('aria-pressed', 'true');
});

test('the first stop skips the bar and the photos', async ({ page }) => {
  await openBoard(page);
  await page.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
  await page.keyboard.press('Tab');
  await expectFocus(page, 'Skip to the comic page');
  await page.keyboard.press('Enter');
  await expectFocus(page, /^Panel 1 of/);
});

test('the photos are one stop before the page, and arrows move between them', async ({ page }) => {
  await openBoard(page);
  const photos = page.getByRole('region', { name: 'Photos' }).getByRole('button', { name: /^Choose / });
  await photos.first().focus();
  const { name } = await focus(page);
  await page.keyboard.press('ArrowRight');
  await expectFocus(page, /^Choose /);
  expect((await focus(page)).name).not.toBe(name);
  for (let i = 0; i < 6 && !/^Panel 1 of/.test((await focus(page)).name); i += 1) await page.keyboard.press('Tab');
  await expectFocus(page, /^Panel 1 of/);
  // Back to the same photo.
  await page.keyboard.press('Shift+Tab');
  expect((await focus(page)).name).not.toContain(name.replace('Choose ', ''));
});

test('a layout and a style are applied', async ({ page }) => {
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

test('a photo is moved, enlarged and swapped', async ({ page }) => {
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
  await tabTo(page, 'More');
  await page.keyboard.press('Enter');
  await tabTo(page, 'Swap photo');
  await page.keyboard.press('Enter');
  await tabTo(page, 'Panel 2 of 4', { back: true });
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await idle(page);
  await expectFocus(page, 'Panel 4 of 4');
  expect(await shown()).toEqual([photos[0], photos[3], photos[2], photos[1]]);
});

test('a cut is moved by its buttons', async ({ page }) => {
  await four(page);
  await page.getByRole('button', { name: 'Shuffle', exact: true }).focus();
  await tabTo(page, 'Edit layout', { back: true });
  await page.keyboard.press('Enter');
  await tabTo(page, /^Divider 1 of/, { back: true });
  // The buttons move the cut that had the focus last.
  const cuts = page.getByRole('slider', { name: /^Divider \d of/ });
  const places = () => cuts.evaluateAll((all) => all.map((cut) => cut.getAttribute('aria-valuetext')));
  const before = await places();
  await tabTo(page, 'Move divider right or down');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect.poll(places).not.toEqual(before);
  await tabTo(page, 'Done');
  await page.keyboard.press('Enter');
  await expect(cuts).toHaveCount(0);
  await expectAnyFocus(page);
});

test('a slider of the designer is moved, and the focus returns to the button of the designer', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Style designer');
  await page.keyboard.press('Enter');
  // The button has the same name as the region.
  await expect(page.getByRole('region', { name: 'Style designer', exact: true })).toBeFocused();
  await startEmpty(page);
  await tabTo(page, 'Add block');
  await page.keyboard.press('Enter');
  await page.keyboard.type('Posterization');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await tabTo(page, 'Levels');
  const value = () => page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).value);
  const before = await value();
  await page.keyboard.press('ArrowRight');
  expect(await value()).not.toBe(before);
  await page.keyboard.press('Escape');
  await expectFocus(page, 'Style designer');
});

test('a text item is added, moved and removed', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Styles');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await expectFocus(page, 'Text');
  await tabTo(page, 'Add balloon');
  await page.keyboard.press('Enter');
  await expectFocus(page, /^Text of/);
  await page.keyboard.type('By keys');
  await page.keyboard.press('Enter');
  await expectFocus(page, 'Balloon: By keys');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Delete');
  await expect(page.getByRole('button', { name: 'Balloon: By keys' })).toHaveCount(0);
  await expectAnyFocus(page);
});

test('a photo is removed, and the focus moves to the next', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, /^Remove .*jpg$/);
  const gone = (await focus(page)).name;
  await page.keyboard.press('Enter');
  await expectFocus(page, /^(Choose|Use|Star|Remove) .*jpg$/);
  await idle(page);
  expect((await focus(page)).name).not.toBe(gone);
});

test('the export dialog is opened and left, and Ctrl+S saves the page in print size', async ({ page }) => {
  await openBoard(page);
  await tabTo(page, 'Export');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await expectFocus(page, 'Export');
  // The browser hides the dialog before its close event. Keys are ignored until then.
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  const file = await saved(page, () => page.keyboard.press('Control+s'));
  const png = PNG.sync.read(file.bytes);
  expect([png.width, png.height]).toEqual([2480, 3508]);
});

test('L, S and P shuffle the layout, the style and the photos', async ({ page }) => {
  await openBoard(page);
  for (const [key, part] of /** @type {const} */ ([
    ['l', 'layout'],
    ['s', 'style'],
    ['p', 'photos'],
  ])) {
    const before = await contents(page);
    await page.keyboard.press(key);
    await idle(page);
    expect((await contents(page))[part]).not.toEqual(before[part]);
  }
});

test('arrows move the focus between panels, which are one tab stop', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  const option = page.getByRole('listbox', { name: 'Layouts' }).getByRole('option');
  await option.first().click();
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('6');
  await idle(page);
  const panels = page.getByRole('group', { name: /^Panel \d of \d$/ });
  expect(
    await panels.evaluateAll(
      (list) => list.filter((panel) => /** @type {HTMLElement} */ (panel).tabIndex === 0).length,
    ),
  ).toBe(1);
  await panels.first().focus();
  /** @type {Set<string | null | undefined>} */
  const seen = new Set();
  for (const key of ['ArrowDown', 'ArrowRight', 'ArrowDown', 'ArrowRight', 'ArrowUp', 'ArrowLeft', 'ArrowUp']) {
    seen.add(await page.evaluate(() => document.activeElement?.getAttribute('aria-label')));
    await page.keyboard.press(key);
  }
  expect(seen.size).toBeGreaterThanOrEqual(3);
  for (const name of seen) expect(name).toMatch(/^Panel \d of 6$/);
});

test('arrows, Home and End move the focus in a list, and Enter applies a style', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Styles');
  const box = page.getByRole('listbox', { name: 'Styles' });
  await box.getByRole('option', { selected: true }).focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect(box.getByRole('option').nth(1)).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect(box.getByRole('option').last()).toHaveAttribute('aria-selected', 'true');
});

test('? opens the list of shortcuts, and Escape closes it', async ({ page }) => {
  await openBoard(page);
  await page.keyboard.press('?');
  const dialog = page.getByRole('dialog', { name: 'Keyboard shortcuts' });
  await expect(dialog).toBeVisible();
  const before = await picture(page);
  await page.keyboard.press('Space');
  expect(await picture(page)).toBe(before);
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
});

test('shortcuts of single letters can be switched off, also after a reload', async ({ page }) => {
  await openStart(page);
  await idle(page);
  await page.getByRole('button', { name: 'Menu' }).click();
  await page.getByRole('button', { name: 'Keyboard shortcuts' }).click();
  await page.getByRole('checkbox', { name: 'Single-letter shortcuts' }).uncheck();
  await page.keyboard.press('Escape');
  await page.reload();
  await idle(page);
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toHaveCount(0);
});
