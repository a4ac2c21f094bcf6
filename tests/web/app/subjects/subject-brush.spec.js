// @ts-check
/** The brush that corrects the subject of a photo, with mouse, keys and touch. */

import {
  add,
  choose,
  detectingTest,
  different,
  expect,
  idle,
  offences,
  openBoard,
  photos,
  picture,
  sharedBoardTest as test,
  reach,
} from '../support.js';
import { expectSaved } from '../project-files.js';
import { touch, way } from '../touch.js';
import { box, word, write } from '../text-items.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const panel = (/** @type {Page} */ page, /** @type {number} */ n) =>
  page.getByRole('group', { name: new RegExp(`^Panel ${n} of`) });
const dialog = (/** @type {Page} */ page) => page.getByRole('dialog', { name: /^Subject of/ });
const area = (/** @type {Page} */ page) => page.getByRole('application', { name: /^Subject of/ });

/** Opens a page of four equal panels that do not overlap. @param {Page} page @param {...string} names of photos */
async function four(page, ...names) {
  await openBoard(page, names);
  await choose(page, 'grid', 'Four');
}

/** Opens the brush on the photo of a panel. @param {Page} page @param {number} [n] */
async function openBrush(page, n = 1) {
  await panel(page, n).click();
  await (await reach(page, 'Correct subject')).click();
  await expect(area(page)).toBeFocused();
  await expect(area(page).locator('.bitmap')).toHaveAttribute('data-drawn', 'true');
}

/** Paints along points, which are in parts of the photo. @param {Page} page @param {[number, number][]} points */
async function stroke(page, points) {
  const { x, y, width, height } = await box(area(page));
  const at = (/** @type {[number, number]} */ [u, v]) =>
    /** @type {[number, number]} */ ([x + u * width, y + v * height]);
  await page.mouse.move(...at(points[0]));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...at(point), { steps: 4 });
  await page.mouse.up();
}

/** The part of the photo that the subject covers, in percent. @param {Page} page */
async function covered(page) {
  const told = await dialog(page).getByRole('status').textContent();
  return Number(/(\d+)\s*%/.exec(told ?? '')?.[1] ?? -1);
}

/** @param {Page} page @param {string} name */
async function style(page, name) {
  await page.getByRole('tab', { name: 'Styles', exact: true }).click();
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name, exact: true }).click();
  await idle(page);
}

const SNAKE = /** @type {[number, number][]} */ ([
  [0.35, 0.3],
  [0.65, 0.3],
  [0.65, 0.45],
  [0.35, 0.45],
  [0.35, 0.6],
  [0.65, 0.6],
]);

test('a painted subject is drawn in its own layer, undone stroke by stroke, and restored by a reload', async ({
  page,
}) => {
  await four(page, 'macaw.jpg', 'camera.jpg');
  await style(page, 'Silhouette');
  const before = await picture(page);
  await openBrush(page);
  expect(await covered(page)).toBe(0);
  await dialog(page).getByRole('slider', { name: 'Brush size' }).fill('0.8');
  await stroke(page, SNAKE);
  const first = await covered(page);
  expect(first).toBeGreaterThan(8);
  await stroke(page, [
    [0.5, 0.7],
    [0.5, 0.8],
  ]);
  expect(await covered(page)).toBeGreaterThan(first);
  // Painted away.
  await dialog(page).getByRole('button', { name: 'Remove' }).click();
  await stroke(page, [[0.5, 0.8]]);
  await dialog(page).getByRole('button', { name: 'Undo' }).click();
  await dialog(page).getByRole('button', { name: 'Redo' }).click();
  const whole = await covered(page);
  expect(await picture(page)).toBe(before);
  await dialog(page).getByRole('button', { name: 'Done' }).click();
  await expect(dialog(page)).toBeHidden();
  await expect.poll(async () => different(before, await picture(page))).toBeGreaterThan(500);
  await idle(page);
  const after = await picture(page);
  // Each of the three strokes is one undo step.
  for (let i = 0; i < 3; i += 1) await page.getByRole('button', { name: 'Undo' }).first().click();
  await expect.poll(async () => different(before, await picture(page))).toBe(0);
  for (let i = 0; i < 3; i += 1) await page.getByRole('button', { name: 'Redo' }).first().click();
  await expect.poll(async () => different(after, await picture(page))).toBe(0);
  await idle(page);
  await expectSaved(page);
  await page.reload();
  await idle(page);
  await expect.poll(async () => different(after, await picture(page)), { timeout: 20_000 }).toBe(0);
  await openBrush(page);
  expect(await covered(page)).toBe(whole);
  await dialog(page).getByRole('button', { name: 'Use detected subject' }).click();
  await dialog(page).getByRole('button', { name: 'Done' }).click();
  await expect.poll(async () => different(before, await picture(page))).toBe(0);
});

test('a painted mask breaks the panel border, and each correction updates the page', async ({ page }) => {
  await four(page, 'macaw.jpg', 'camera.jpg', 'dahlia.jpg', 'pika.jpg');
  await panel(page, 1).click();
  const breaks = await reach(page, 'Break out of panel');
  await expect(breaks).toBeDisabled();
  /** Paints subjects until one breaks the border of its panel. A panel may have no room for this. */
  const broken = async () => {
    for (let n = 1; n <= (await page.getByRole('group', { name: /^Panel \d+ of/ }).count()); n += 1) {
      await openBrush(page, n);
      await dialog(page).getByRole('slider', { name: 'Brush size' }).fill('0.85');
      await stroke(page, SNAKE);
      await dialog(page).getByRole('button', { name: 'Done' }).click();
      await idle(page);
      await breaks.click();
      if ((await breaks.getAttribute('aria-pressed')) === 'true') return n;
    }
    throw new Error('no figure steps out');
  };
  const n = await broken();
  await idle(page);
  const out = await picture(page);
  await openBrush(page, n);
  for (let i = 0; i < 8; i += 1) await dialog(page).getByRole('button', { name: 'Shrink' }).click();
  await dialog(page).getByRole('button', { name: 'Done' }).click();
  await expect.poll(async () => different(out, await picture(page))).toBeGreaterThan(100);
  await idle(page);
  for (let i = 0; i < 8; i += 1) await page.getByRole('button', { name: 'Undo' }).first().click();
  await expect.poll(async () => different(out, await picture(page))).toBe(0);
});

test('keyboard: the brush is moved, paints and undoes', async ({ page }) => {
  await openBoard(page, ['macaw.jpg']);
  const pick = page.getByRole('button', { name: 'Choose macaw.jpg' });
  await pick.focus();
  await page.keyboard.press('Enter');
  const open = page.getByRole('button', { name: 'Correct the subject of macaw.jpg' });
  await open.focus();
  await page.keyboard.press('Enter');
  await expect(area(page)).toBeFocused();
  for (let i = 0; i < 6; i += 1) await page.keyboard.press(']');
  await page.keyboard.press('Space');
  const dab = await covered(page);
  expect(dab).toBeGreaterThan(2);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  const two = await covered(page);
  expect(two).toBeGreaterThan(dab);
  // Two subjects that do not touch: N chooses one after the other.
  await page.keyboard.press('n');
  expect(await covered(page)).toBeLessThan(two);
  await page.keyboard.press('Control+z');
  expect(await covered(page)).toBe(two);
  for (let i = 0; i < 4; i += 1) await page.keyboard.press('+');
  const grown = await covered(page);
  expect(grown).toBeGreaterThan(two);
  await page.keyboard.press('-');
  expect(await covered(page)).toBeLessThan(grown);
  await page.keyboard.press('d');
  await expect(dialog(page).getByRole('button', { name: 'Remove' })).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Space');
  await page.keyboard.press('c');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Space');
  // The board hears nothing of it.
  await expect(page.getByRole('button', { name: 'Undo', exact: true }).first()).toBeAttached();
  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  // The painted mask can be restored for a while.
  await page.getByRole('button', { name: 'Restore changes' }).click();
  await pick.focus();
  if ((await pick.getAttribute('aria-pressed')) === 'false') await page.keyboard.press('Enter');
  await open.focus();
  await page.keyboard.press('Enter');
  await expect(area(page)).toBeFocused();
  expect(await covered(page)).toBeGreaterThan(0);
});

test('axe finds nothing in the dialog, in both themes', async ({ page }) => {
  await four(page, 'macaw.jpg');
  await openBrush(page);
  await stroke(page, SNAKE);
  expect(await offences(page)).toEqual([]);
  await page.evaluate(() => {
    document.documentElement.dataset.theme = 'dark';
  });
  expect(await offences(page)).toEqual([]);
  await page.evaluate(() => {
    delete document.documentElement.dataset.theme;
  });
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });

  test('a finger paints, and all controls are large enough for a finger', async ({ page }) => {
    await openBoard(page, ['macaw.jpg', 'camera.jpg']);
    await page.getByRole('button', { name: 'Layouts', exact: true }).click();
    await choose(page, 'grid', 'Four');
    await page.getByRole('button', { name: 'Close' }).click();
    await panel(page, 1).tap();
    await (await reach(page, 'Correct subject')).tap();
    await expect(area(page)).toBeVisible();
    const { x, y, width, height } = await box(area(page));
    expect(x).toBeGreaterThanOrEqual(0);
    expect(x + width).toBeLessThanOrEqual(360);
    await touch(page, [way([x + 0.3 * width, y + 0.5 * height], [x + 0.7 * width, y + 0.5 * height])]);
    await expect.poll(() => covered(page)).toBeGreaterThan(1);
    const small = await dialog(page)
      .locator('button, input')
      .evaluateAll((all) =>
        all
          .map((one) => ({ name: one.textContent || one.getAttribute('aria-label'), box: one.getBoundingClientRect() }))
          .filter(({ box: { width: w, height: h } }) => w < 44 || h < 44)
          .map(({ name }) => name),
      );
    expect(small).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
    expect(await offences(page)).toEqual([]);
  });
});

test('a new balloon avoids a painted subject', async ({ page }) => {
  await four(page, 'macaw.jpg');
  const balloon = word(page, /^Balloon: HELLO THERE/);
  /** Adds and removes a balloon, and returns its place. */
  const place = async () => {
    await write(page, 'balloon', 'HELLO THERE');
    const { x, y, width, height } = await box(balloon);
    await page.getByRole('button', { name: 'Remove text' }).click();
    await expect(balloon).toBeHidden();
    return { x: x + width / 2, y: y + height / 2, width, height };
  };
  const first = await place();
  const shown = await box(panel(page, 1));
  const left = first.x < shown.x + shown.width / 2;
  // The half of the photo on which it was is a body now.
  await openBrush(page);
  await dialog(page).getByRole('slider', { name: 'Brush size' }).fill('1');
  for (const x of [0.1, 0.25, 0.35])
    await stroke(page, [
      [left ? x : 1 - x, 0],
      [left ? x : 1 - x, 1],
    ]);
  await dialog(page).getByRole('button', { name: 'Done' }).click();
  await idle(page);
  const second = await place();
  const away = Math.hypot((second.x - first.x) / first.width, (second.y - first.y) / first.height);
  expect(away).toBeGreaterThan(0.3);
  // Without the body it goes where it went.
  await openBrush(page);
  await dialog(page).getByRole('button', { name: 'Use detected subject' }).click();
  await dialog(page).getByRole('button', { name: 'Done' }).click();
  await idle(page);
  const third = await place();
  expect([third.x, third.y]).toEqual([first.x, first.y]);
});

detectingTest('subject detection can be stopped and resumed', async ({ page }) => {
  /** @type {string[]} */
  const nets = [];
  let release = () => {};
  const held = new Promise((resolve) => {
    release = () => resolve(undefined);
  });
  await page.route('**/*subject*.onnx', async (route) => {
    nets.push(route.request().url());
    await held;
    await route.continue();
  });
  await page.goto('./');
  await add(page, await photos('macaw.jpg', 'camera.jpg'));
  await idle(page);
  await choose(page, 'grid', 'Four');
  const stop = page.getByRole('button', { name: 'Stop subject detection' });
  await stop.click({ timeout: 120_000 });
  const goOn = page.getByRole('button', { name: 'Resume subject detection' });
  await expect(goOn).toBeVisible();
  await expect(stop).toBeHidden();
  await expect(page.locator('body')).toHaveAttribute('data-masked', 'true');
  release();
  await panel(page, 1).click();
  const breaks = await reach(page, 'Break out of panel');
  await expect(breaks).toHaveAttribute('title', /subject detection was stopped/);
  // A new photo does not resume it.
  await add(page, await photos('dahlia.jpg'));
  await expect(page.getByRole('button', { name: 'Choose dahlia.jpg' })).toBeVisible();
  await idle(page);
  await expect(goOn).toBeVisible();
  await expect(stop).toBeHidden();
  await goOn.click();
  await expect(page.locator('body')).toHaveAttribute('data-masked', 'true', { timeout: 120_000 });
  await expect(goOn).toBeHidden();
  // Another selection closed the list of all tools.
  await panel(page, 1).click();
  await expect(await reach(page, 'Break out of panel')).toBeEnabled();
});
