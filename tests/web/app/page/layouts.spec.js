// @ts-check
/** Layouts: families, page sizes, layouts of the user, layout files and cuts. */

import { download, saved } from '../export-dialog.js';
import { reloadSaved } from '../project-files.js';
import {
  SIX,
  accessible,
  choose,
  contents,
  drop,
  expect,
  idle,
  makePageSmall,
  openBoard,
  openNewBoard,
  photos,
  reach,
  picture,
  PNG,
  press,
  tab,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

/** @param {Page} page */
const layouts = (page) => page.getByRole('listbox', { name: 'Layouts' });
const cut = (/** @type {Page} */ page, /** @type {number} */ n = 1) =>
  page.getByRole('slider', { name: new RegExp(`^Divider ${n} of`) });

/** Width over height of a baseline JPEG file. @param {Buffer} file */
function shapeOf(file) {
  const frame = file.indexOf(Buffer.from([0xff, 0xc0, 0x00]));
  return file.readUInt16BE(frame + 7) / file.readUInt16BE(frame + 5);
}

/**
 * Returns the layout file that `Save layout` saves.
 * @param {Page} page
 * @returns {Promise<{ name: string, bytes: Buffer, layout: any }>}
 */
async function savedLayout(page) {
  await tab(page, 'Layouts');
  const { name, bytes } = await saved(page, () => page.getByRole('button', { name: 'Save layout' }).click());
  return { name, bytes, layout: JSON.parse(bytes.toString()) };
}

/** @param {Page} page */
const exported = async (page) => PNG.sync.read((await download(page)).bytes);

/** A paper colour that no photo contains. */
const PAPER = '#ff00fe';

/**
 * Finds the horizontal gutters of a page.
 * @param {PNG} png
 * @returns {number[]} the middles of the gutters, as fractions of the height
 */
function gutters({ data, width, height }) {
  const paper = (/** @type {number} */ y) => {
    for (let x = Math.round(width * 0.05); x < width * 0.95; x += 7) {
      const i = (y * width + x) * 4;
      if (data[i] !== 255 || data[i + 1] !== 0 || data[i + 2] !== 254) return false;
    }
    return true;
  };
  /** @type {number[]} */
  const found = [];
  let from = -1;
  for (let y = 0; y <= height; y += 1) {
    const is = y < height && paper(y);
    if (is && from < 0) from = y;
    if (!is && from >= 0) {
      if (from > 0 && y < height) found.push((from + y) / 2 / height);
      from = -1;
    }
  }
  return found;
}

test('the list shows the layouts of a family, and those that suit the page size', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  const family = page.getByRole('combobox', { name: 'Family' });
  await family.selectOption('grid');
  const names = await layouts(page)
    .getByRole('option')
    .evaluateAll((list) => list.map((option) => option.getAttribute('aria-label')));
  expect(names.length).toBeGreaterThan(2);
  await layouts(page).getByRole('option').nth(1).click();
  await idle(page);
  expect((await contents(page)).layout).toBe(names[1]);
  const before = await picture(page);
  await tab(page, 'Page');
  await page.getByRole('slider', { name: 'Gutter' }).fill('4');
  await idle(page);
  expect(await picture(page)).not.toBe(before);
  // A tall page has other layouts, because some panels would be too narrow.
  await tab(page, 'Layouts');
  await family.selectOption('');
  const all = await layouts(page).getByRole('option').count();
  await tab(page, 'Page');
  await page.getByRole('combobox', { name: 'Page size' }).selectOption('webtoon');
  await idle(page);
  await tab(page, 'Layouts');
  const tall = await layouts(page).getByRole('option').count();
  expect(tall).toBeGreaterThan(5);
  expect(tall).not.toBe(all);
});

test('photos are shown whole in a layout that follows their shapes', async ({ page }) => {
  await openBoard(page);
  const shapes = new Map((await photos(...SIX)).map(({ name, buffer }) => [name, shapeOf(buffer)]));
  // Slanted dividers would stay, and their panels have other shapes.
  await choose(page, 'grid', 'Four');
  await tab(page, 'Page');
  await page.getByRole('region', { name: 'Page settings' }).getByLabel('Keep photos whole').check();
  await idle(page);
  const panels = await page
    .getByRole('region', { name: 'Comic page' })
    .getByRole('group', { name: /^Panel \d/ })
    .all();
  expect(panels.length).toBeGreaterThan(2);
  for (const panel of panels) {
    const [name] = ((await panel.getAttribute('aria-description')) ?? '').split(',');
    const { width, height } = (await panel.boundingBox()) ?? { width: 0, height: 1 };
    expect(Math.abs(Math.log(width / height / (shapes.get(name) ?? 0))), name).toBeLessThan(0.05);
  }
});

test('a custom page size is entered in millimetres, and a wrong value is reported', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Page');
  const settings = page.getByRole('region', { name: 'Page settings' });
  await settings.getByLabel('Page size').selectOption('custom');
  await settings.getByLabel('Unit').selectOption('mm');
  await expect(settings.getByLabel('Width')).toHaveValue('210');
  await settings.getByLabel('Width').fill('148');
  await settings.getByLabel('Height').fill('105');
  await idle(page);
  const box = await page.locator('.page-canvas').boundingBox();
  expect((box?.width ?? 0) / (box?.height ?? 1)).toBeCloseTo(148 / 105, 1);
  await settings.getByLabel('Resolution (DPI)').fill('5');
  await expect(settings.getByText('The resolution must be from 36 to 1200 DPI.')).toBeVisible();
  await expect(settings.getByLabel('Resolution (DPI)')).toHaveAttribute('aria-invalid', 'true');
  await settings.getByLabel('Resolution (DPI)').fill('150');
  await idle(page);
  await expect(settings.getByText('The resolution must be')).toHaveCount(0);
  const png = await exported(page);
  expect([png.width, png.height]).toEqual([874, 620]);
});

test('a surprise layout is saved to a file and to My layouts, and loaded again', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Layouts');
  await page.getByRole('combobox', { name: 'Panels' }).selectOption('4');
  const before = await picture(page);
  await press(page, 'New layout');
  expect(await picture(page)).not.toBe(before);
  const shown = await contents(page);
  expect(shown.photos.length).toBe(4);
  expect(shown.layout).toMatch(/^Surprise/);
  const { name, layout, bytes } = await savedLayout(page);
  expect(name).toBe(`${layout.id}.json`);
  const mine = layouts(page).getByRole('group', { name: 'My layouts' });
  await expect(mine.getByRole('option', { selected: true })).toHaveAccessibleName(layout.name);
  await press(page, 'Shuffle layout');
  await mine.getByRole('option', { name: layout.name }).click();
  await idle(page);
  expect((await contents(page)).layout).toBe(layout.name);
  await press(page, 'Remove from My layouts');
  await expect(mine).toHaveCount(0);
  // Without stored data, only the file has the layout.
  await openNewBoard(page);
  await page.getByLabel('Layout file').setInputFiles({ name, mimeType: 'application/json', buffer: bytes });
  await idle(page);
  expect((await contents(page)).layout).toBe(layout.name);
  expect((await savedLayout(page)).layout).toEqual(layout);
  await reloadSaved(page);
  await tab(page, 'Layouts');
  await expect(mine.getByRole('option', { name: layout.name })).toBeVisible();
});

test('an invalid layout file is reported with its name, the place and the reason', async ({ page }) => {
  await openBoard(page);
  const before = await contents(page);
  const bad = {
    id: 'bad',
    name: 'Bad',
    family: 'custom',
    aspect: 0.7,
    tree: { rows: ['panel', { columns: ['panel', 'pannel'] }] },
  };
  const files = [bad, '{ "id": '].map((text, i) => ({
    name: `bad-${i}.json`,
    mimeType: 'application/json',
    buffer: Buffer.from(typeof text === 'string' ? text : JSON.stringify(text)),
  }));
  await drop(page, files);
  await page.getByRole('alert').getByRole('button', { name: 'Show the list' }).click();
  const list = page.getByRole('dialog');
  await expect(list).toContainText(/bad-0\.json.*tree\.rows\[1\]\.columns\[1\]/);
  await expect(list).toContainText(/bad-1\.json.*line 1/);
  await page.keyboard.press('Escape');
  expect(await contents(page)).toEqual(before);
});

test('a cut is moved by mouse and keyboard, and the PNG file shows it', async ({ page }) => {
  await openBoard(page);
  await makePageSmall(page);
  await choose(page, 'grid', 'Three thirds');
  await tab(page, 'Page');
  await page.getByLabel('Paper colour').fill(PAPER);
  await idle(page);
  const first = gutters(await exported(page));
  expect(first.length).toBeGreaterThan(0);
  await tab(page, 'Layouts');
  await (await reach(page, 'Edit layout')).click();
  const handle = cut(page);
  const value = async () => Number(await handle.getAttribute('aria-valuenow'));
  const start = await value();
  const box = /** @type {NonNullable<Awaited<ReturnType<typeof handle.boundingBox>>>} */ (await handle.boundingBox());
  const canvas = await page.locator('.page-canvas').boundingBox();
  const by = (canvas?.height ?? 0) * 0.08;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 + by / 2);
  // The handle moves during the drag.
  expect(await value()).toBeGreaterThan(start);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 + by, { steps: 4 });
  await page.mouse.up();
  await idle(page);
  const dragged = await value();
  expect(dragged - start).toBeGreaterThanOrEqual(6);
  const second = gutters(await exported(page));
  expect(second[0] - first[0]).toBeGreaterThan(0.05);
  expect(second[0] - first[0]).toBeLessThan(0.1);
  // One drag is one undo step.
  await press(page, 'Undo');
  expect(await value()).toBe(start);
  await press(page, 'Redo');
  expect(await value()).toBe(dragged);
  await handle.focus();
  await page.keyboard.press('ArrowUp');
  await idle(page);
  expect(await value()).toBe(dragged - 1);
  await page.keyboard.press('Shift+ArrowUp');
  await idle(page);
  expect(await value()).toBe(dragged - 6);
  await page.keyboard.press('Alt+ArrowRight');
  await idle(page);
  await expect(handle).toHaveAttribute('aria-valuetext', /slanted by 2%/);
  const { layout } = await savedLayout(page);
  expect(layout.family).toBe('custom');
  expect(layout.tree.slants[0]).toBeCloseTo(0.02, 3);
});

test('the mouse drags a gutter of a page that is not edited, as one undo step', async ({ page }) => {
  await openBoard(page);
  await choose(page, 'grid', 'Three thirds');
  const gutter = page.locator('.gutter').first();
  const middle = async () => {
    const box = await gutter.boundingBox();
    return { x: (box?.x ?? 0) + (box?.width ?? 0) / 2, y: (box?.y ?? 0) + (box?.height ?? 0) / 2 };
  };
  const start = await middle();
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(start.x, start.y + 40, { steps: 4 });
  await page.mouse.up();
  await idle(page);
  expect((await middle()).y).toBeCloseTo(start.y + 40, -1);
  await press(page, 'Undo');
  expect((await middle()).y).toBeCloseTo(start.y, 0);
  // A panel is not below a gutter.
  await page.getByRole('group', { name: 'Panel 1 of 3' }).click();
  await expect(page.getByRole('toolbar', { name: 'Panel tools' })).toBeVisible();
});

test('an inset is moved and sized by mouse, keyboard and tools, one undo step each', async ({ page }) => {
  await openBoard(page);
  await choose(page, 'inset', 'Inset');
  await (await reach(page, 'Edit layout')).click();
  const inset = page.getByRole('button', { name: 'Inset 1 of 1', exact: true });
  const box = async () => {
    const found = await inset.boundingBox();
    if (!found) throw new Error('no inset');
    return found;
  };
  const start = await box();
  const drag = async (/** @type {[number, number]} */ [x, y], /** @type {[number, number]} */ [dx, dy]) => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 2 });
    await page.mouse.move(x + dx, y + dy, { steps: 3 });
    await page.mouse.up();
    await idle(page);
  };
  await drag([start.x + start.width / 2, start.y + start.height / 2], [-60, -90]);
  const moved = await box();
  expect(Math.abs(moved.x - start.x + 60)).toBeLessThan(4);
  expect(Math.abs(moved.y - start.y + 90)).toBeLessThan(4);
  expect(Math.abs(moved.width - start.width)).toBeLessThan(3);
  // A corner changes the size, and the opposite corner stays.
  await drag([moved.x, moved.y], [-40, -30]);
  const sized = await box();
  expect(Math.abs(sized.width - moved.width - 40)).toBeLessThan(4);
  expect(Math.abs(sized.height - moved.height - 30)).toBeLessThan(4);
  expect(Math.abs(sized.x + sized.width - moved.x - moved.width)).toBeLessThan(4);
  // An inset never leaves the page.
  await drag([sized.x + sized.width / 2, sized.y + sized.height / 2], [900, 900]);
  const [edge, canvas] = [await box(), await page.locator('.page-canvas').boundingBox()];
  expect(edge.x + edge.width).toBeLessThanOrEqual((canvas?.x ?? 0) + (canvas?.width ?? 0));
  await press(page, 'Undo');
  await press(page, 'Undo');
  expect(Math.abs((await box()).width - moved.width)).toBeLessThan(2);
  await inset.focus();
  const before = await box();
  await page.keyboard.press('ArrowLeft');
  await idle(page);
  expect((await box()).x).toBeLessThan(before.x - 2);
  await page.keyboard.press('Alt+ArrowRight');
  await idle(page);
  expect((await box()).width).toBeGreaterThan(before.width + 2);
  await press(page, 'Move inset up');
  expect((await box()).y).toBeLessThan(before.y - 4);
  const small = await box();
  await press(page, 'Enlarge inset');
  expect((await box()).width).toBeGreaterThan(1.05 * small.width);
  await accessible(page);
  const { layout } = await savedLayout(page);
  expect(layout.family).toBe('custom');
  await press(page, 'Done');
  await expect(inset).toHaveCount(0);
});
