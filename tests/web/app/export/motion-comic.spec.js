// @ts-check
/** Pages as a film, read panel by panel, and panels of films that move: in the page, in a film and in an HTML comic. */

import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { openExport, saved } from '../export-hands.js';
import { probed } from '../film-hands.js';
import { accessible, add, different, expect, idle, openBoard, pixelsOf, tab, test } from '../support.js';
import { write } from '../word-hands.js';

/** @typedef {import('../support.js').Page} Page */
/** @typedef {ReturnType<Page['locator']>} Locator */

const run = promisify(execFile);
const CAT = fileURLToPath(new URL('../../../photos/cat.jpg', import.meta.url));

/**
 * A film of three seconds: a photo that stands still, and over its left half a square that wanders where `moves`.
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

/** Chooses a style of which panels may move. @param {Page} page */
async function styled(page) {
  await tab(page, 'Styles');
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'Adventure Album' }).click();
  await idle(page);
}

/** @param {Page} page */
async function openMotion(page) {
  const dialog = await openExport(page);
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption({ label: 'Motion page' });
  await expect(dialog.getByRole('group', { name: 'Motion page' })).toBeVisible();
  await expect(dialog.getByText(/^1 page, 0:\d\d at 24 frames a second$/)).toBeVisible();
  return dialog;
}

/** Leaves out the moves of the camera, which makes the film shorter. @param {Locator} dialog */
async function standStill(dialog) {
  const facts = dialog.getByText(/^1 page, /);
  const before = await facts.textContent();
  await dialog.getByRole('checkbox', { name: 'Camera moves' }).uncheck();
  await expect(facts).not.toHaveText(String(before));
}

/** What a frame shows once it is drawn. @param {Locator} dialog @param {number} frame */
async function frameOf(dialog, frame) {
  await dialog.getByRole('slider', { name: 'Position' }).fill(String(frame));
  const screen = dialog.getByRole('img');
  await expect(screen).toHaveAttribute('data-shown', String(frame), { timeout: 30_000 });
  return screen.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
}

/** How many pixels of the two pictures are not the same. @param {string} a @param {string} b */
function apart(a, b) {
  const [one, other] = [pixelsOf(a), pixelsOf(b)];
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4)
    if ([0, 1, 2].some((channel) => one.data[i + channel] !== other.data[i + channel])) count += 1;
  return count;
}

/** The frames in which the camera stays at the first panel, its moves left out: from 1.2 s on, for two seconds at least. */
const STAYS = [32, 70];

test('a page is read panel by panel, its words appear, and the film is exact to the frame', async ({ page }) => {
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
  // The camera went there, and stays; what is new is the balloon.
  expect(apart(whole, before)).toBeGreaterThan(10_000);
  expect(apart(before, after)).toBeGreaterThan(300);
  expect(apart(before, after)).toBeLessThan(apart(whole, before) / 2);
  // Once it is read often a canvas is scaled by other code, whose pixels differ by a step.
  expect(different(await frameOf(dialog, STAYS[0]), before)).toBe(0);
  const frames = Number(await position.getAttribute('max')) + 1;
  await accessible(page);
  await dialog.getByRole('combobox', { name: 'Size' }).selectOption('720p');
  await expect(dialog.getByText(/^1 page, /)).toBeVisible();
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  await expect(page.getByText('The motion page was saved.')).toBeVisible();
  const { complaints, streams } = await probed(file.path);
  expect(complaints).toBe('');
  expect(streams[0]).toMatchObject({ width: 1280, height: 720, nb_read_frames: String(frames) });
});

test('it plays by keyboard alone', async ({ page }) => {
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
  ['a panel moves where its film does', true],
  ['a panel whose film stands still does not change by a single pixel', false],
]))
  test(name, async ({ page }, info) => {
    await page.goto('./');
    await add(page, [await film(info.outputPath('film.webm'), moves)]);
    await styled(page);
    const dialog = await openMotion(page);
    await standStill(dialog);
    await expect(dialog.locator('canvas[data-moving]')).toHaveCount(1, { timeout: 60_000 });
    const panels = Number(await dialog.getByRole('img').getAttribute('data-moving'));
    expect(panels).toBeGreaterThan(0);
    // The page as a whole, as it is for 1.2 s.
    const frames = [2, 8, 18, 26];
    /** @type {string[]} */
    const pictures = [];
    for (const frame of frames) pictures.push(await frameOf(dialog, frame));
    if (moves) expect(apart(pictures[0], pictures[2])).toBeGreaterThan(200);
    else expect(pictures.every((picture) => picture === pictures[0])).toBe(true);
    await dialog.getByRole('checkbox', { name: 'Panels from films move' }).uncheck();
    await expect(dialog.getByRole('img')).not.toHaveAttribute('data-moving');
    const still = await frameOf(dialog, frames[0]);
    expect(await frameOf(dialog, frames[2])).toBe(still);
  });

test('an HTML comic moves, can be stopped, and rests where a person wants no motion', async ({ page }, info) => {
  test.setTimeout(240_000);
  await page.goto('./');
  await add(page, [await film(info.outputPath('film.webm'), true)]);
  await styled(page);
  const dialog = await openExport(page);
  await dialog.getByRole('combobox', { name: 'Quality' }).selectOption('0.5');
  await dialog.getByRole('combobox', { name: 'Format' }).selectOption('html');
  // On a busy machine it was not there within half a minute, once.
  await expect(dialog.getByRole('checkbox', { name: 'Panels from films move' })).toBeChecked({ timeout: 120_000 });
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Save the file' }).click());
  const path = info.outputPath('comic.html');
  await writeFile(path, file.bytes);
  const reader = await page.context().newPage();
  await reader.goto(`file://${path}`);
  const moving = reader.locator('image.moving');
  expect(await moving.count()).toBeGreaterThan(0);
  await reader.waitForTimeout(500);
  const shot = async () => (await reader.screenshot()).toString('base64');
  const first = await shot();
  await expect.poll(shot).not.toBe(first);
  await accessible(reader);
  await reader.getByRole('button', { name: 'Motion' }).press('Enter');
  await expect(reader.getByRole('button', { name: 'Motion' })).toHaveAttribute('aria-pressed', 'false');
  await reader.waitForTimeout(300);
  const rests = await shot();
  await reader.waitForTimeout(500);
  expect(await shot()).toBe(rests);
  await reader.emulateMedia({ reducedMotion: 'reduce' });
  await reader.getByRole('button', { name: 'Pages' }).click();
  await expect(reader.getByRole('button', { name: 'Motion' })).toBeHidden();
  for (let i = 0; i < (await moving.count()); i += 1) await expect(moving.nth(i)).toBeHidden();
});
