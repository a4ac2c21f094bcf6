// @ts-check
/** Every screen of the page, and the way to it from a board of six photos: for tests that go through all of them. */

import { drawn } from './style-designer.js';
import { four, panel } from './panels.js';
import { add, choose, expect, idle, photos, reach, tab, test } from './support.js';
import { openWords } from './text-items.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */

const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole('button', { name, exact: true });

/** @param {Page} page @param {string} name of a part that is folded on a wide screen */
async function unfold(page, name) {
  const summary = page.locator('summary').filter({ hasText: name });
  if (!(await summary.evaluate((element) => /** @type {HTMLDetailsElement} */ (element.parentElement).open)))
    await summary.click();
}

/** Opens a view, which is in the menu of a small screen. @param {Page} page @param {string} name */
async function work(page, name) {
  if (!(await button(page, name).isVisible())) await button(page, 'Menu').click();
  await button(page, name).click();
}

/** Opens a drawer of a small screen, or a tab of a large one. @param {Page} page @param {string} name */
async function drawer(page, name) {
  if (await button(page, name).isVisible()) await button(page, name).click();
  else await page.getByRole('tab', { name, exact: true }).click();
}

/** The photos are always in view on a large screen. @param {Page} page */
async function photoDrawer(page) {
  if (await button(page, 'Photos').isVisible()) await button(page, 'Photos').click();
}

/** Waits for the first wall of styles, which appears automatically. @param {Page} page */
async function invented(page) {
  await expect(page.locator('.wall-item').nth(5)).toBeVisible();
  await expect(page.getByRole('region', { name: 'Style explorer' })).toHaveAttribute('aria-busy', 'false', {
    timeout: 180_000,
  });
}

/** Screens of a wide and of a small window. @type {Record<string, (page: Page) => Promise<void>>} */
const SCREENS = {
  board: async () => {},
  'a panel is chosen': (page) => panel(page, 2).click(),
  'all tools of a panel': async (page) => {
    await panel(page, 2).click();
    await reach(page, 'Save subject as PNG');
  },
  'a photo is cropped': async (page) => {
    await panel(page, 2).click();
    await button(page, 'Crop').click();
  },
  menu: (page) => button(page, 'Menu').click(),
  'a photo is moved': async (page) => {
    await panel(page, 2).focus();
    await page.keyboard.press('Enter');
  },
  cuts: async (page) => {
    await drawer(page, 'Layouts');
    await (await reach(page, 'Edit layout')).click();
    await page.getByRole('slider', { name: /^Divider 1 of/ }).focus();
  },
  photos: async (page) => {
    await photoDrawer(page);
    await unfold(page, 'Photo selection');
    await (await reach(page, 'Show subjects')).click();
  },
  'a stack': async (page) => {
    await add(
      page,
      (await photos('cat.jpg')).map((photo) => ({ ...photo, name: 'cat again.jpg' })),
    );
    await idle(page);
    await photoDrawer(page);
    await page.getByRole('button', { name: /^Show the 2 photos similar to/ }).click();
  },
  'styles and how they are chosen': async (page) => {
    await drawer(page, 'Styles');
    await (await reach(page, 'Shuffle settings')).click();
  },
  layouts: async (page) => {
    await drawer(page, 'Layouts');
    await page.getByRole('combobox', { name: 'Family' }).selectOption('slanted');
  },
  words: async (page) => {
    await drawer(page, 'Text');
    await openWords(page);
    await button(page, 'Add balloon').click();
    await expect(page.getByRole('textbox', { name: /^Text of/ })).toBeFocused();
    await page.keyboard.press('Enter');
  },
  'page settings': async (page) => {
    if (await page.getByRole('tab').first().isVisible()) await tab(page, 'Page');
    else {
      await button(page, 'Menu').click();
      await button(page, 'Page settings').click();
    }
    await page.getByRole('combobox', { name: 'Page size' }).selectOption('custom');
    await unfold(page, 'Alt text');
  },
  designer: async (page) => {
    await work(page, 'Style designer');
    await drawn(page);
  },
  'blocks of the designer': async (page) => {
    await work(page, 'Style designer');
    await button(page, 'Add block').click();
    await drawn(page);
  },
  'the page in the designer': async (page) => {
    await work(page, 'Style designer');
    await button(page, 'Page').click();
    await drawn(page);
  },
  'comparison in the designer': async (page) => {
    await work(page, 'Style designer');
    await button(page, 'Compare with original').click();
    await drawn(page);
  },
  'an empty explorer': async (page) => {
    await work(page, 'Explore styles');
    await invented(page);
    await button(page, 'Clear').click();
  },
  explorer: async (page) => {
    await work(page, 'Explore styles');
    await invented(page);
  },
  'a style seen large': async (page) => {
    await work(page, 'Explore styles');
    await invented(page);
    await page.locator('.wall-item').nth(2).click();
    await expect(page.locator('.enlarged-picture[aria-busy=false]')).toBeVisible();
  },
  'pages shown': async (page) => {
    await button(page, 'Shuffle').click();
    await idle(page);
    await page.getByRole('button', { name: /^Page history/ }).click();
    await expect(page.getByRole('button', { name: 'Version 2', exact: true })).toBeVisible();
  },
  projects: (page) => button(page, 'Projects').click(),
  'export dialog': async (page) => {
    await button(page, 'Export').click();
    await expect(page.getByRole('dialog').locator('canvas[data-drawn=true]')).toBeVisible();
  },
  help: (page) => page.keyboard.press('?'),
  'what went wrong': async (page) => {
    await button(page, 'Lock style').click();
    await add(page, [{ name: 'notes.txt', mimeType: 'text/plain', buffer: Buffer.from('no photo') }]);
    await expect(page.getByRole('alert')).toContainText('notes.txt');
    await page.keyboard.press('s');
  },
  'files that could not be read': async (page) => {
    await add(
      page,
      ['notes.txt', 'more.txt', 'a name that is too long for one line of a telephone held upright.txt'].map((name) => ({
        name,
        mimeType: 'text/plain',
        buffer: Buffer.from('no photo'),
      })),
    );
    await page.getByRole('alert').getByRole('button', { name: 'Show the list' }).click();
    await expect(page.getByRole('dialog').getByRole('listitem')).toHaveCount(3);
  },
  'a storyboard of two pages': async (page) => {
    await (await reach(page, 'Add page')).click();
    await idle(page);
    const tools = button(page, 'Page tools');
    if (await tools.isVisible()) await tools.click();
    await expect(button(page, 'Move page earlier')).toBeVisible();
  },
};

/** A page of four equal panels, so that no screen depends on a random layout. @param {Page} page */
export async function openFour(page) {
  if (/** @type {{ width: number }} */ (page.viewportSize()).width >= 1000) await four(page);
  else {
    await page.goto('./');
    await add(page, await photos('bee.jpg', 'cat.jpg', 'gateway.jpg', 'macaw.jpg'));
    await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
    await idle(page);
    await button(page, 'Layouts').click();
    await choose(page, 'grid', 'Four');
    await back(page);
  }
}

/** Returns to the board by keyboard only. @param {Page} page */
async function back(page) {
  for (let i = 0; i < 5; i += 1) {
    await page.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
    await page.keyboard.press('Escape');
    // Closed parts disappear in the next frame, and earlier keys would have no effect.
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))));
  }
  for (const dismiss of await page.getByRole('button', { name: 'Dismiss' }).all()) await dismiss.click();
}

/**
 * Opens all screens. A screen that cannot be opened is recorded, and the others are still checked.
 * @param {Page} page
 * @param {(name: string) => Promise<void>} look
 * @param {Record<string, unknown>} wrong findings by screen
 */
export async function lookAtScreens(page, look, wrong) {
  for (const [name, open] of Object.entries(SCREENS)) {
    await test
      .step(name, async () => {
        await open(page);
        await look(name);
        await back(page);
      })
      .catch(async (error) => {
        wrong[name] = String(error.message).slice(0, 400);
        await back(page);
      });
  }
}
