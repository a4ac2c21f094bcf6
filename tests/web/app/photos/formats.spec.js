// @ts-check
/** File formats of photos and animations. */

import { readFile } from 'node:fs/promises';
import { download } from '../export-dialog.js';
import { panel } from '../panels.js';
import { saved } from '../project-files.js';
import {
  PNG,
  add,
  colours,
  contents,
  expect,
  idle,
  makePageSmall,
  openBoard,
  openStart,
  photos,
  picture,
  pixelsOf,
  press,
  sharedBoardTest as test,
} from '../support.js';

const DATA = new URL('../../../oracles/data/', import.meta.url);

/** @param {string} path @param {string} [name] @returns {Promise<{ name: string, mimeType: string, buffer: Buffer }>} */
async function file(path, name = path.split('/').at(-1) ?? path) {
  return { name, mimeType: `image/${name.split('.').at(-1)}`, buffer: await readFile(new URL(path, DATA)) };
}

/** @param {import('../support.js').Page} page @param {RegExp} name */
const boxes = (page, name) => page.getByRole('checkbox', { name });

/**
 * Puts a photo into the first panel.
 * @param {import('../support.js').Page} page
 * @param {RegExp} name
 */
async function place(page, name) {
  await page.getByRole('region', { name: 'Photos' }).getByRole('button', { name }).first().click();
  await panel(page, 1).click();
  await idle(page);
  await page.keyboard.press('Escape');
}

const STILLS = ['gif.gif', 'webp-lossy.webp', 'webp-lossless.webp'];
const ANIMATIONS = ['kept.gif', 'lossless.webp'];

test('photos in AVIF, HEIC, GIF and WebP are put into panels, and the page is saved from an AVIF photo', async ({
  page,
}) => {
  await openStart(page);
  const files = [file('heic/grid.heic'), file('foreign/plain.avif'), ...STILLS.map((name) => file(`files/${name}`))];
  await add(page, await Promise.all(files));
  await idle(page);
  for (const name of [...STILLS, 'grid.heic', 'plain.avif']) {
    await expect(boxes(page, new RegExp(`^Use ${name}$`))).toHaveCount(1);
    await place(page, new RegExp(`^Choose ${name}$`));
    expect((await contents(page)).photos[0]).toBe(name);
    expect(colours(pixelsOf(await picture(page)))).toBeGreaterThan(2);
  }
  await makePageSmall(page);
  expect((await download(page)).bytes.length).toBeGreaterThan(10_000);
});

test('the pictures of animations are used like the frames of a video', async ({ page }) => {
  await openStart(page);
  const whole = await file('animations/kept.gif');
  const part = { ...whole, name: 'part.gif', buffer: whole.buffer.subarray(0, Math.floor(whole.buffer.length * 0.8)) };
  const animations = await Promise.all(ANIMATIONS.map((name) => file(`animations/${name}`)));
  await add(page, [...animations, part, ...(await photos('pagoda.jpg'))]);
  await idle(page);
  // Six pictures of different duration: four of them are visible at one of six equal intervals.
  for (const name of ANIMATIONS) await expect(boxes(page, new RegExp(`^Use ${name}, 0:00`))).toHaveCount(4);
  await expect(boxes(page, /^Use pagoda/)).toBeChecked();
  // A truncated animation has the pictures that are complete.
  expect(await boxes(page, /^Use part\.gif/).count()).toBeGreaterThan(2);
  for (const name of ANIMATIONS) {
    await place(page, new RegExp(`^Choose ${name}, 0:00`));
    expect((await contents(page)).photos[0]).toContain(name);
  }
  await press(page, 'Shuffle');
});

test('other pictures of an animation are used, and one undo step restores the first ones', async ({ page }) => {
  await openBoard(page, ['kept.gif'], [await file('animations/kept.gif')]);
  expect((await contents(page)).photos.some((shown) => shown?.startsWith('kept.gif'))).toBe(true);
  const taken = boxes(page, /^Use kept\.gif, 0:00/);
  const names = () => taken.evaluateAll((all) => all.map((box) => box.getAttribute('aria-label')));
  const before = await names();
  expect(before.length).toBe(4);
  await page.getByText(/^\d+ frames$/).click();
  await page.getByRole('slider', { name: 'Frames from the video' }).fill('2');
  await page.getByRole('button', { name: 'Use these frames' }).click();
  await expect(taken).toHaveCount(2);
  await idle(page);
  await press(page, 'Undo');
  expect(await names()).toEqual(before);
  await expect(page.getByRole('group', { name: 'Panel 1 of' }).first()).toBeVisible();
});

test('photos of all formats are rotated, and stay so after a reload', async ({ page }) => {
  const png = new PNG({ width: 90, height: 60 });
  png.data.fill(120);
  await openStart(page);
  const files = ['heic/grid.heic', 'foreign/plain.avif', 'files/gif.gif', 'files/webp-lossy.webp'].map((name) =>
    file(name),
  );
  const drawn = { name: 'drawn.png', mimeType: 'image/png', buffer: PNG.sync.write(png) };
  await add(page, [...(await Promise.all(files)), drawn, ...(await photos('bee.jpg'))]);
  await idle(page);
  /** @returns {Promise<[name: string, aspect: number][]>} all stored photos. Undo can restore some of them */
  const stored = () =>
    page.evaluate(async () => {
      const open = indexedDB.open('inkpanel');
      await new Promise((resolve) => open.addEventListener('success', resolve));
      const request = open.result.transaction('photos').objectStore('photos').getAll();
      await new Promise((resolve) => request.addEventListener('success', resolve));
      open.result.close();
      return request.result.map(({ name, work }) => [name, work.width / work.height]);
    });
  await saved(page);
  const before = await stored();
  expect(before.length).toBe(6);
  for (const [name] of before) {
    if ((await contents(page)).photos[0] !== name) await place(page, new RegExp(`^Choose ${name}$`));
    await panel(page, 1).click();
    await press(page, 'Rotate photo');
  }
  await saved(page);
  await page.reload();
  await idle(page);
  expect((await contents(page)).photos[0]).toBe(before.at(-1)?.[0]);
  const rotated = before.map(([name, aspect]) => [name, 1 / aspect]);
  const rounded = (/** @type {any[]} */ list) => list.map(([name, aspect]) => `${name} ${aspect.toFixed(2)}`).sort();
  expect(rounded(await stored())).toEqual(rounded([...before, ...rotated]));
});
