// @ts-check
/** Times of frames: they start at the first picture of a video. */

import { readFile } from 'node:fs/promises';
import { add, expect, idle, test } from '../support.js';

const TIMES = new URL('../../../videos/times/', import.meta.url);

/** @param {string} name */
async function video(name) {
  return { name, mimeType: 'video/mp4', buffer: await readFile(new URL(name, TIMES)) };
}

/**
 * Returns the times in the names of the frames of each video.
 * @param {import('../support.js').Page} page @param {string[]} names
 */
async function timesOf(page, names) {
  const times = [];
  for (const name of names) {
    await add(page, [await video(name)]);
    await idle(page);
    const used = page.getByRole('checkbox', { name: new RegExp(`^Use ${name}, `) });
    const labels = await used.evaluateAll((boxes) => boxes.map((box) => box.getAttribute('aria-label') ?? ''));
    times.push(labels.map((label) => label.replace(/^.*, /, '')).sort());
  }
  return times;
}

// These videos have the same pictures. The first one is at 11.4 s in late.ts, and two seconds after the sound in late.mp4.
test('times of frames start at the first picture, whatever its time in the file', async ({ page }) => {
  await page.goto('./');
  const [times, ...late] = await timesOf(page, ['day.mp4', 'late.ts', 'late.mp4']);
  expect(times.length).toBeGreaterThan(4);
  expect(late).toEqual([times, times]);
});

test('times of frames start at the first picture in the player of the browser, too', async ({ page }) => {
  await page.route('**/video-worker-*.js', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `delete globalThis.VideoDecoder;${await response.text()}` });
  });
  await page.goto('./');
  const [times, late] = await timesOf(page, ['day.mp4', 'late.mp4']);
  expect(times.length).toBeGreaterThan(4);
  expect(late).toEqual(times);
});

test('each frame has at most one reason, which is not cut', async ({ page }) => {
  await page.goto('./');
  await add(page, [await video('day.mp4')]);
  await idle(page);
  const counts = await page.locator('.photo').evaluateAll((photos) =>
    photos.map((photo) => {
      const reasons = [...photo.querySelectorAll('.photo-why')].filter((reason) => reason.checkVisibility());
      return [reasons.length, reasons.filter((reason) => reason.scrollWidth > reason.clientWidth).length];
    }),
  );
  expect(counts).toContainEqual([1, 0]);
  expect(counts.filter(([all, cut]) => all > 1 || cut > 0)).toEqual([]);
});
