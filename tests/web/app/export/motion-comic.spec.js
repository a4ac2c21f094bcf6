// @ts-check
/** Motion comics: pages read panel by panel as a video, and panels from videos that move in a video and an HTML comic. */

import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { chooseFormat, openExport, saved } from '../export-dialog.js';
import { probed } from '../video-files.js';
import { accessible, different, expect, idle, openBoard, pixelsOf, tab, sharedBoardTest as test } from '../support.js';
import { write } from '../text-items.js';

/** @typedef {import('../support.js').Page} Page */
/** @typedef {ReturnType<Page['locator']>} Locator */

const run = promisify(execFile);
const CAT = fileURLToPath(new URL('../../../photos/cat.jpg', import.meta.url));

/**
 * Makes a video of three seconds: a still photo, and a square that moves over its left half if `moves`.
 * @param {string} path
 * @param {boolean} moves
 */
async function film(path, moves) {
  const graph = moves
    ? '[0]scale=320:240,fps=24[a];color=orange:s=60x60:r=24:d=3[b];[a][b]overlay=x=20+20*t:y=60+20*t:shortest=1'
    : '[0]scale=320:240,fps=24';
  const input = ['-v', 'error', '-loop', '1', '-t', '3', '-i', CAT];
  const output = ['-c:v', 'libvpx-vp9', '-b:v', '300k', '-pix_fmt', 'yuv420p', path];
  await run('ffmpeg', [...input, '-filter_complex', graph, ...output]);
  return { name: 'film.webm', mimeType: 'video/webm', buffer: await readFile(path) };
}

/** Chooses a style that allows moving panels. @param {Page} page */
async function styled(page) {
  await tab(page, 'Styles');
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'Adventure Album' }).click();
  await idle(page);
}

/** @param {Page} page */
async function openMotion(page) {
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'motion');
  await expect(dialog.getByRole('group', { name: 'Motion comic' })).toBeVisible();
  await expect(dialog.getByText(/^1 page, 0:\d\d at 24 frames per second$/)).toBeVisible();
  return dialog;
}

/** Switches the camera moves off, which makes the video shorter. @param {Locator} dialog */
async function standStill(dialog) {
  const facts = dialog.getByText(/^1 page, /);
  const before = await facts.textContent();
  await dialog.getByRole('checkbox', { name: 'Camera moves' }).uncheck();
  await expect(facts).not.toHaveText(String(before));
}

/** The image of a frame, after it is drawn. @param {Locator} dialog @param {number} frame */
async function frameOf(dialog, frame) {
  await dialog.getByRole('slider', { name: 'Position' }).fill(String(frame));
  const screen = dialog.getByRole('img');
  await expect(screen).toHaveAttribute('data-shown', String(frame), { timeout: 30_000 });
  return screen.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
}

/** Counts the pixels that differ between two images. @param {string} a @param {string} b */
function apart(a, b) {
  const [one, other] = [pixelsOf(a), pixelsOf(b)];
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4)
    if ([0, 1, 2].some((channel) => one.data[i + channel] !== other.data[i + channel])) count += 1;
  return count;
}

/** Frames in which the camera shows the first panel, without camera moves: from 1.2 s on, for at least two seconds. */
const STAYS = [32, 70];

test('a page is read panel by panel, its text items appear, and the video has the exact number of frames', {
  tag: '@ci',
}, async ({ page }) => {
  await openBoard(page, ['bee.jpg', 'cat.jpg', 'gateway.jpg']);
  await write(page, 'balloon', 'Well, hello there');
  const dialog = await openMotion(page);
  const position = dialog.getByRole('slider', { name: 'Position' });
  await expect(position).toHaveAttribute('aria-valuetext', /page 1$/);
  await standStill(dialog);
  const screen = dialog.getByRole('img');
  const seen = () =>
    screen.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL('image/webp', 0.5).length);
  await expect.poll(seen).toBeGreaterThan(1500);
  const whole = await frameOf(dialog, 0);
  const [before, after] = [await frameOf(dialog, STAYS[0]), await frameOf(dialog, STAYS[1])];
  await expect(position).toHaveAttribute('aria-valuetext', /page 1, panel 1$/);
  // The camera moved to the panel and stays. The balloon is new.
  expect(apart(whole, before)).toBeGreaterThan(10_000);
  expect(apart(before, after)).toBeGreaterThan(300);
  expect(apart(before, after)).toBeLessThan(apart(whole, before) / 2);
  // A canvas that is read often is scaled by other code, whose pixels differ slightly.
  expect(different(await frameOf(dialog, STAYS[0]), before)).toBe(0);
  const frames = Number(await position.getAttribute('max')) + 1;
  await accessible(page);
  await dialog.getByRole('combobox', { name: 'Size' }).selectOption('720p');
  await expect(dialog.getByText(/^1 page, /)).toBeVisible();
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  await expect(page.getByText(`${file.name} was saved.`)).toBeVisible();
  const { complaints, streams } = await probed(file.path);
  expect(complaints).toBe('');
  expect(streams[0]).toMatchObject({ width: 1280, height: 720, nb_read_frames: String(frames) });
});

test('keyboard: a motion comic plays', async ({ page }) => {
  await openBoard(page, ['bee.jpg', 'cat.jpg', 'gateway.jpg']);
  const dialog = await openMotion(page);
  const position = dialog.getByRole('slider', { name: 'Position' });
  await position.focus();
  await page.keyboard.press('Space');
  await expect(dialog.getByRole('button', { name: 'Pause' })).toBeVisible();
  await expect(position).toHaveAttribute('aria-valuetext', /panel 1$/);
  await page.keyboard.press('Space');
  await expect(dialog.getByRole('button', { name: 'Play' })).toBeVisible();
  await page.keyboard.press('End');
  await expect(position).toHaveAttribute('aria-valuetext', /page 1$/);
});

for (const [name, moves] of /** @type {const} */ ([
  ['a panel of a still video does not change by a single pixel', false],
  ['a panel moves if its video moves', true],
]))
  test(name, { tag: '@ci' }, async ({ page }, info) => {
    await openBoard(page, [`video, moves: ${moves}`], [await film(info.outputPath('film.webm'), moves)]);
    await styled(page);
    const dialog = await openMotion(page);
    await standStill(dialog);
    await expect(dialog.locator('canvas[data-moving]')).toHaveCount(1, { timeout: 60_000 });
    const panels = Number(await dialog.getByRole('img').getAttribute('data-moving'));
    expect(panels).toBeGreaterThan(0);
    // For 1.2 s the video shows the whole page.
    const frames = [2, 8, 18, 26];
    /** @type {string[]} */
    const pictures = [];
    for (const frame of frames) pictures.push(await frameOf(dialog, frame));
    if (moves) expect(apart(pictures[0], pictures[2])).toBeGreaterThan(200);
    else expect(pictures.every((picture) => picture === pictures[0])).toBe(true);
    await dialog.getByRole('checkbox', { name: 'Animate panels with video frames' }).uncheck();
    await expect(dialog.getByRole('img')).not.toHaveAttribute('data-moving');
    const still = await frameOf(dialog, frames[0]);
    expect(await frameOf(dialog, frames[2])).toBe(still);
  });

test('an HTML comic moves, can be stopped, and respects reduced motion', { tag: '@ci' }, async ({ page }, info) => {
  test.setTimeout(240_000);
  await openBoard(page, ['video, moves: true'], [await film(info.outputPath('film.webm'), true)]);
  await styled(page);
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'html');
  await dialog.getByRole('combobox', { name: 'Resolution' }).selectOption('0.5');
  // On a busy machine this takes more than half a minute.
  await expect(dialog.getByRole('checkbox', { name: 'Animate panels with video frames' })).toBeChecked({
    timeout: 120_000,
  });
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  const path = info.outputPath('comic.html');
  await writeFile(path, file.bytes);
  const reader = await page.context().newPage();
  await reader.goto(`file://${path}`);
  const moving = reader.locator('image.moving');
  expect(await moving.count()).toBeGreaterThan(0);
  const shot = async () => (await reader.screenshot()).toString('base64');
  const first = await shot();
  await expect.poll(shot).not.toBe(first);
  await accessible(reader);
  await reader.getByRole('button', { name: 'Motion' }).press('Enter');
  await expect(reader.getByRole('button', { name: 'Motion' })).toHaveAttribute('aria-pressed', 'false');
  for (let i = 0; i < (await moving.count()); i += 1) await expect(moving.nth(i)).toBeHidden();
  const still = await shot();
  for (let i = 0; i < 3; i += 1) expect(await shot()).toBe(still);
  await reader.emulateMedia({ reducedMotion: 'reduce' });
  await reader.getByRole('button', { name: 'Pages' }).click();
  await expect(reader.getByRole('button', { name: 'Motion' })).toBeHidden();
  for (let i = 0; i < (await moving.count()); i += 1) await expect(moving.nth(i)).toBeHidden();
});
