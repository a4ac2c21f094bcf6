// @ts-check
import { readFile } from 'node:fs/promises';
import { add, contents, expect, idle, photos, press, test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */

const VIDEOS = new URL('../../../videos/', import.meta.url);

/** @param {string} name @param {string} mimeType */
async function video(name, mimeType) {
  return { name, mimeType, buffer: await readFile(new URL(name, VIDEOS)) };
}

/** @param {Page} page */
const frames = (page) => page.getByRole('checkbox', { name: /^Use album/ });

/** Seconds into the film, of the frames in the tray in their order. @param {Page} page */
async function times(page) {
  const names = await frames(page).evaluateAll((boxes) => boxes.map((box) => box.getAttribute('aria-label') ?? ''));
  return names.map((name) => {
    const [, minutes, seconds] = /(\d+):([\d.]+)$/.exec(name) ?? [];
    return Number(minutes) * 60 + Number(seconds);
  });
}

for (const [name, type] of [
  ['album.mp4', 'video/mp4'],
  ['album.webm', 'video/webm'],
]) {
  test(`the frames of ${name} become a page`, async ({ page }) => {
    await page.goto('./');
    await add(page, [await video(name, type)]);
    await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
    await idle(page);
    // Six shots of a second each, and as many frames as any film has at least.
    await expect(frames(page)).toHaveCount(8);
    const seconds = await times(page);
    expect(new Set(seconds.map(Math.floor)).size).toBe(6);
    expect(seconds).toEqual([...seconds].sort((a, b) => a - b));
    expect((await times(page)).every((time) => time > 0 && time < 6)).toBe(true);
    const shown = new Set((await contents(page)).photos);
    expect(shown.size).toBeGreaterThan(2);
    await press(page, 'Shuffle');
  });
}

test('a film lies on the table beside photos, and its frames are judged apart', async ({ page }) => {
  await page.goto('./');
  await add(page, [await video('album.mp4', 'video/mp4'), ...(await photos('pagoda.jpg'))]);
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: 'Use pagoda.jpg' })).toBeChecked();
  const used = await frames(page).evaluateAll(
    (boxes) => boxes.filter((box) => /** @type {HTMLInputElement} */ (box).checked).length,
  );
  // Six shots of a second each.
  expect(used).toBeGreaterThanOrEqual(6);
  expect(used).toBeLessThanOrEqual(8);
});

test('other frames are taken of a stretch of the film, and one undo brings the old ones back', async ({ page }) => {
  await page.goto('./');
  await add(page, [await video('album.mp4', 'video/mp4')]);
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  await page.getByText('8 frames').click();
  await page.getByRole('slider', { name: 'Start' }).fill('2');
  await page.getByRole('slider', { name: 'End' }).fill('4');
  await page.getByRole('slider', { name: 'Frames from the film' }).fill('12');
  await page.getByRole('button', { name: 'Take these frames' }).click();
  await expect(frames(page)).toHaveCount(12);
  await idle(page);
  expect((await times(page)).every((time) => time >= 2 && time <= 4)).toBe(true);
  await press(page, 'Undo');
  await expect(frames(page)).toHaveCount(8);
});

test('a film that was recorded on its side stands upright', async ({ page }) => {
  await page.goto('./');
  await add(page, [await video('turned.mov', 'video/quicktime')]);
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download PNG' }).click(),
  ]);
  expect(await download.path()).toBeTruthy();
});

test('a file that is no film is named with the reason', async ({ page }) => {
  await page.goto('./');
  await add(page, [
    { name: 'broken.mp4', mimeType: 'video/mp4', buffer: Buffer.from('this is not a film') },
    ...(await photos('bee.jpg', 'cat.jpg')),
  ]);
  await expect(page.getByRole('alert').getByText(/broken\.mp4: .{8,}/)).toBeVisible();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: /^Use broken/ })).toHaveCount(0);
});

test('a panel’s frame is exchanged for a later one by the tool and by the keys, each one step', async ({ page }) => {
  await page.goto('./');
  await add(page, [await video('album.mp4', 'video/mp4')]);
  await expect(page.getByRole('region', { name: 'Storyboard page' })).toBeVisible();
  await idle(page);
  const shown = async () => (await contents(page)).photos.map((name) => name?.replace(', selected', ''));
  const before = { times: await times(page), photos: await shown() };
  const panel = page.getByRole('region', { name: 'Storyboard page' }).getByRole('group', { name: /^Panel 1 of/ });
  await panel.click();
  const changed = async () => (await times(page)).filter((time) => !before.times.includes(time));
  await page.getByRole('button', { name: 'Later frame' }).click();
  await expect.poll(async () => (await changed()).length).toBe(1);
  await idle(page);
  const [later] = await changed();
  expect(before.times.some((time) => Math.abs(later - time - 0.1) < 0.02)).toBe(true);
  expect((await shown())[0]).not.toBe(before.photos[0]);
  await press(page, 'Undo');
  expect(await times(page)).toEqual(before.times);
  expect(await shown()).toEqual(before.photos);
  await panel.focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press(',');
  await expect.poll(async () => (await changed()).length).toBe(1);
  await press(page, 'Undo');
  expect(await times(page)).toEqual(before.times);
});
