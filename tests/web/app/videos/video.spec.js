// @ts-check
import { readFile } from 'node:fs/promises';
import { download, saved } from '../export-dialog.js';
import {
  add,
  contents,
  different,
  drop,
  expect,
  idle,
  makePageSmall,
  openBoard,
  openNewBoard,
  openStart,
  photos,
  picture,
  press,
  reach,
  sharedBoardTest as test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

const VIDEOS = new URL('../../../videos/', import.meta.url);

/** @param {string} name @param {string} mimeType */
async function video(name, mimeType) {
  return { name, mimeType, buffer: await readFile(new URL(name, VIDEOS)) };
}

/** @param {Page} page */
const frames = (page) => page.getByRole('checkbox', { name: /^Use album/ });

/** The times of the frames in the tray, in seconds, in their order. @param {Page} page */
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
  test(`the frames of ${name} become a comic page`, async ({ page }) => {
    await openBoard(page, [name], [await video(name, type)]);
    // The video has six shots of one second. The minimum is eight frames.
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

test('a video is used together with photos, and its frames are compared only with each other', async ({ page }) => {
  await openStart(page);
  await add(page, [await video('album.mp4', 'video/mp4'), ...(await photos('pagoda.jpg'))]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: 'Use pagoda.jpg' })).toBeChecked();
  const used = await frames(page).evaluateAll(
    (boxes) => boxes.filter((box) => /** @type {HTMLInputElement} */ (box).checked).length,
  );
  // The video has six shots of one second.
  expect(used).toBeGreaterThanOrEqual(6);
  expect(used).toBeLessThanOrEqual(8);
});

test('other frames are extracted from a part of the video, and one undo step restores the first ones', async ({
  page,
}) => {
  await openBoard(page, ['album.mp4'], [await video('album.mp4', 'video/mp4')]);
  await page.getByText('8 frames').click();
  await page.getByRole('slider', { name: 'Start' }).fill('2');
  await page.getByRole('slider', { name: 'End' }).fill('4');
  await page.getByRole('slider', { name: 'Frames from the video' }).fill('12');
  await page.getByRole('button', { name: 'Use these frames' }).click();
  await expect(frames(page)).toHaveCount(12);
  await idle(page);
  expect((await times(page)).every((time) => time >= 2 && time <= 4)).toBe(true);
  await press(page, 'Undo');
  await expect(frames(page)).toHaveCount(8);
});

test('a video that was recorded on its side is shown upright', async ({ page }) => {
  await openBoard(page, ['turned.mov'], [await video('turned.mov', 'video/quicktime')]);
  await makePageSmall(page);
  expect((await download(page)).path).toBeTruthy();
});

test('a file that is not a video is reported with the reason', async ({ page }) => {
  await openStart(page);
  await add(page, [
    { name: 'broken.mp4', mimeType: 'video/mp4', buffer: Buffer.from('this is not a film') },
    ...(await photos('bee.jpg', 'cat.jpg')),
  ]);
  await expect(page.getByRole('alert').getByText(/broken\.mp4: .{8,}/)).toBeVisible();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: /^Use broken/ })).toHaveCount(0);
});

test('the frame of a panel is replaced by a later or earlier one, by button and by key, as one undo step', async ({
  page,
}) => {
  await openBoard(page, ['album.mp4'], [await video('album.mp4', 'video/mp4')]);
  const shown = async () => (await contents(page)).photos.map((name) => name?.replace(', selected', ''));
  const before = { times: await times(page), photos: await shown() };
  const panel = page.getByRole('region', { name: 'Comic page' }).getByRole('group', { name: /^Panel 1 of/ });
  await panel.click();
  const changed = async () => (await times(page)).filter((time) => !before.times.includes(time));
  await (await reach(page, 'Later frame')).click();
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

test('a project with a video opens from its file as the same page', async ({ page }) => {
  await openNewBoard(page, ['album.mp4'], [await video('album.mp4', 'video/mp4')]);
  const before = { ...(await contents(page)), times: await times(page) };
  const drawn = await picture(page);
  await page.getByLabel('Project name').fill('Video');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Projects', exact: true }).click();
  const { name, bytes } = await saved(page, () => page.getByRole('button', { name: 'Save project' }).click());
  await page.getByRole('button', { name: 'New project' }).click();
  await expect(frames(page)).toHaveCount(0);
  await drop(page, [{ name, mimeType: '', buffer: bytes }]);
  await expect(frames(page)).toHaveCount(8);
  await idle(page);
  await expect(page.getByRole('alert')).toHaveText('');
  expect({ ...(await contents(page)), times: await times(page) }).toEqual(before);
  expect(different(await picture(page), drawn)).toBe(0);
  // The file contains the video, so other frames can be taken from it.
  await expect(page.getByText('8 frames')).toBeVisible();
});
