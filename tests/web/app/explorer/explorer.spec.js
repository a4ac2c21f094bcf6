// @ts-check
import { FOUR, drawn, invent, names } from '../style-designer.js';
import { reloadSaved } from '../project-files.js';
import { accessible, contents, expect, idle, openBoard, picture, press, reach, tab, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page */
const region = (page) => page.getByRole('region', { name: 'Style explorer' });
/** @param {Page} page */
const wall = (page) => region(page).getByRole('listitem');

/** A machine with other load needs more than 30 seconds for a wall. */
const SLOW = { timeout: 120_000 };

/** Opens the explorer and lets it invent from a seed until there are some. @param {Page} page */
async function explore(page) {
  await invent(page);
  await expect.poll(() => wall(page).count(), SLOW).toBeGreaterThan(24);
}

/** @param {Page} page @param {number} n @param {string} name */
async function deed(page, n, name) {
  await wall(page).nth(n).hover();
  await wall(page).nth(n).getByRole('button', { name, exact: true }).click();
}

/** @param {Page} page */
const scores = (page) =>
  wall(page)
    .getByRole('img')
    .evaluateAll((list) => list.map((label) => Number(label.textContent)));

test('styles are invented, sorted, filtered, favoured, bred and used', async ({ page }) => {
  await explore(page);
  await expect(region(page)).toHaveAttribute('aria-busy', 'false', SLOW);
  await page.getByRole('button', { name: 'Generate' }).click();
  await expect(region(page)).toHaveAttribute('aria-busy', 'true');
  await expect(page.getByRole('progressbar', { name: /Generating styles/ })).toBeVisible();
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
  const count = await wall(page).count();
  await page.getByRole('button', { name: 'Sort by score' }).click();
  const sorted = await scores(page);
  expect(sorted).toEqual([...sorted].sort((a, b) => b - a));
  expect(sorted.every((score) => Number.isInteger(score) && score >= 0 && score <= 100)).toBe(true);
  const look = page.getByRole('combobox', { name: 'Look' });
  let parts = 0;
  for (const kind of ['line', 'flat', 'gray', 'wild']) {
    await look.selectOption(kind);
    parts += await wall(page).count();
  }
  expect(parts).toBe(count);
  await look.selectOption('all');

  const [first, second] = [
    await wall(page).nth(0).getAttribute('aria-label'),
    await wall(page).nth(1).getAttribute('aria-label'),
  ];
  await deed(page, 0, 'Favourite');
  await deed(page, 1, 'Favourite');
  await look.selectOption('favourites');
  await expect(wall(page)).toHaveCount(2);
  await deed(page, 0, 'Combine');
  await expect(region(page)).toContainText(`Choose another style to combine with ${first}`);
  // A click on its picture is enough.
  await wall(page)
    .nth(1)
    .getByRole('button', { name: `Choose ${second}`, exact: true })
    .click();
  await expect(region(page)).toContainText(`combinations of ${first} and ${second}`);
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
  // Beside the second parent, and marked, though the wall shows favourites only.
  const children = wall(page).filter({ hasText: `Combines ${first} and ${second}` });
  const litter = await children.count();
  expect(litter).toBeGreaterThan(0);
  await expect(wall(page)).toHaveCount(2 + litter);
  await expect(wall(page).filter({ hasText: 'Parent' })).toHaveCount(2);
  await look.selectOption('all');
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
  const bred = await wall(page).count();
  expect(bred).toBe(count + litter);
  for (let n = 2; n < 2 + litter; n += 1) await expect(wall(page).nth(n)).toContainText(`Combines ${first}`);
  await deed(page, 2, 'More like this');
  await expect.poll(() => wall(page).count()).toBeGreaterThan(bred);
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');

  await page.keyboard.press('Escape');
  const before = await picture(page);
  await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
  await deed(page, 0, 'Use');
  await idle(page);
  await expect(region(page)).toHaveCount(0);
  expect(await picture(page)).not.toBe(before);
  const { style } = await contents(page);
  await tab(page, 'Styles');
  const styles = page.getByRole('listbox', { name: 'Styles' });
  await expect(
    styles
      .getByRole('group', { name: 'Favourites' })
      .getByRole('option', { name: String(second), exact: true })
      .first(),
  ).toBeVisible();
  await (await reach(page, `Edit ${style}`)).click();
  await drawn(page);
  expect((await names(page)).length).toBeGreaterThan(2);

  await reloadSaved(page);
  await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
  await look.selectOption('favourites');
  await expect(wall(page)).toHaveCount(2);
});

test('the wall is walked, favoured, bred and used by keyboard alone', async ({ page }) => {
  await openBoard(page, FOUR);
  await page.getByRole('button', { name: 'Explore styles', exact: true }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Generate' }).focus();
  await page.keyboard.press('Enter');
  await expect.poll(() => wall(page).count(), { intervals: [100], ...SLOW }).toBeGreaterThan(12);
  await page.getByRole('button', { name: 'Stop' }).focus();
  await page.keyboard.press('Enter');
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
  const count = await wall(page).count();
  for (const n of [0, 1]) {
    await wall(page).nth(n).getByRole('button', { name: 'Favourite' }).focus();
    await page.keyboard.press('Space');
    await expect(wall(page).nth(n).getByRole('button', { name: 'Favourite' })).toHaveAttribute('aria-pressed', 'true');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await expect(wall(page).nth(n).getByRole('button', { name: 'Combine' })).toBeFocused();
    await page.keyboard.press('Enter');
  }
  await expect.poll(() => wall(page).count()).toBeGreaterThan(count);
  await expect(region(page)).toHaveAttribute('aria-busy', 'false');
  const name = await wall(page).first().getAttribute('aria-label');
  await wall(page).first().getByRole('button', { name: 'Use', exact: true }).focus();
  await page.keyboard.press('Enter');
  await idle(page);
  expect((await contents(page)).style).toBe(name);
});

test('a shuffle keeps the layer that is locked, and mixes invented styles in', async ({ page }) => {
  await openBoard(page, FOUR);
  await tab(page, 'Styles');
  await press(page, 'Shuffle settings');
  await page.getByRole('slider', { name: 'Generated styles' }).fill('1');
  const unlisted = page
    .getByRole('listbox', { name: 'Styles' })
    .getByRole('group', { name: 'This page' })
    .getByRole('option', { selected: true });
  await expect(unlisted).toHaveCount(0);
  // Idle time is used to find good styles.
  await expect(async () => {
    await press(page, 'Shuffle style');
    await expect(unlisted).toHaveCount(1, { timeout: 10 });
  }).toPass({ intervals: [5_000] });
  await page.getByRole('slider', { name: 'Generated styles' }).fill('0');
  await page.getByRole('button', { name: 'Lock colours' }).click();
  await press(page, 'Shuffle style');
  expect((await contents(page)).style).toContain(' + ');
  await page.getByRole('button', { name: 'Lock lines' }).click();
  const { style } = await contents(page);
  await press(page, 'Shuffle');
  expect((await contents(page)).style).toBe(style);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(page.getByRole('button', { name: 'Lock lines' })).toHaveAttribute('aria-pressed', 'false');
});

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  test(`axe finds nothing in the explorer, in ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await explore(page);
    await page.getByRole('button', { name: 'Stop' }).click();
    await expect(region(page)).toHaveAttribute('aria-busy', 'false');
    await deed(page, 0, 'Combine');
    await accessible(page);
  });
}

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 760 }, hasTouch: true });

  test('tools of a style have their names below the icons, on its tile and in the large view', async ({ page }) => {
    await openBoard(page, FOUR);
    await page.getByRole('button', { name: 'Menu' }).click();
    await page.getByRole('button', { name: 'Explore styles' }).click();
    await expect.poll(() => wall(page).count(), SLOW).toBeGreaterThan(4);
    // The row of photos scrolls to the chosen one.
    const row = region(page).locator('.photo-picker');
    const ends = () =>
      row.evaluate((element) =>
        [element, /** @type {Element} */ (element.querySelector('[aria-current]'))].map(
          (one) => one.getBoundingClientRect().right,
        ),
      );
    await row.evaluate((element) => {
      element.style.width = '90px';
      element.scrollLeft = 0;
      /** @type {HTMLElement} */ (element.lastElementChild).click();
    });
    await expect(row.getByRole('button').last()).toHaveAttribute('aria-current', 'true');
    const [edge, right] = await ends();
    expect(right).toBeLessThanOrEqual(edge);
    // Styles that look the same on this photo are removed.
    await expect(region(page)).toHaveAttribute('aria-busy', 'false', SLOW);
    await expect.poll(() => wall(page).count(), SLOW).toBeGreaterThan(4);
    const texts = wall(page).nth(1).locator('.icon-text');
    await expect(texts).toHaveText(['Use', 'Edit', 'Combine', 'Similar']);
    const boxes = await texts.evaluateAll((all) => all.map((text) => text.getBoundingClientRect().toJSON()));
    boxes.slice(1).forEach(({ left }, i) => expect(left).toBeGreaterThan(boxes[i].right));
    await wall(page)
      .nth(1)
      .getByRole('button', { name: /^Enlarge/ })
      .click();
    const tools = page.locator('.enlarged-tools');
    for (const name of ['Favourite', 'Edit', 'Combine', 'Similar'])
      await expect(tools.getByText(name, { exact: true }).last()).toBeVisible();
    const use = await tools.getByRole('button', { name: 'Use', exact: true }).boundingBox();
    expect((use?.x ?? 999) + (use?.width ?? 0)).toBeLessThanOrEqual(390);
  });
});
