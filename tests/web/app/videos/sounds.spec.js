// @ts-check
/** Sounds of a video, as sound effects on its frames. */

import { readFile } from 'node:fs/promises';
import { word } from '../text-items.js';
import { accessible, expect, idle, openBoard, press, tab, test } from '../support.js';

/** @typedef {import('../../../../www/testing.ts').Page} Page */

const VIDEOS = new URL('../../../videos/', import.meta.url);
/** Three claps, in seconds. */
const CLAPS = [1.5, 3.2, 4.6];

/** Opens a video and the tab of the text items. @param {Page} page @param {string} name */
async function open(page, name) {
  await openBoard(page, [name], [{ name, mimeType: 'video/webm', buffer: await readFile(new URL(name, VIDEOS)) }]);
  await tab(page, 'Text');
}

/** @param {Page} page */
const list = (page) => page.getByRole('list', { name: 'Sounds in sounds.webm' });

/** The times of the proposed sounds, in seconds. @param {Page} page */
async function times(page) {
  const texts = await list(page).getByRole('listitem').locator('.sound-time').allInnerTexts();
  return texts.map((text) => Number(text.split(':')[1]));
}

test('claps in a video are proposed, one is put on its frame, and one undo step removes it', async ({ page }) => {
  await open(page, 'sounds.webm');
  await page.getByRole('button', { name: 'Sounds in the video', exact: true }).click();
  await expect(list(page)).toBeVisible();
  const found = await times(page);
  expect(found.length).toBeGreaterThan(0);
  for (const time of found) expect(CLAPS.some((clap) => Math.abs(clap - time) < 0.1)).toBe(true);
  await expect(page.getByRole('status').filter({ hasText: /sounds? near/ })).toBeVisible();
  await accessible(page);

  const first = list(page).getByRole('listitem').first();
  await expect(first.getByRole('button')).toHaveCount(3);
  const clap = first.getByRole('button').first();
  const text = await clap.innerText();
  await expect(clap).toHaveAccessibleName(new RegExp(`^Add ${text} to the page, 0:`));
  await clap.focus();
  await page.keyboard.press('Enter');
  await expect(word(page, `Sound effect: ${text}`)).toHaveCount(1);
  await idle(page);
  await expect(clap).toHaveAttribute('aria-pressed', 'true');
  await expect(clap).toBeFocused();
  await expect(first.getByText('on the page')).toBeVisible();
  // A sound is not added twice, also not with another text.
  await first.getByRole('button').nth(1).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.words').getByRole('button', { name: /^Sound effect/ })).toHaveCount(1);
  await accessible(page);

  await press(page, 'Undo');
  await expect(page.locator('.words').getByRole('button', { name: /^Sound effect/ })).toHaveCount(0);
  await expect(clap).toHaveAttribute('aria-pressed', 'false');
  await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeDisabled();
});

test('a video without sound is reported', async ({ page }) => {
  await open(page, 'album.webm');
  await page.getByRole('button', { name: 'Sounds in the video', exact: true }).click();
  await expect(page.getByRole('status').filter({ hasText: 'This video has no sound.' })).toBeVisible();
  await accessible(page);
});

test('the search for sounds can be cancelled and repeated', async ({ page }) => {
  // The browser decodes after the test allows it.
  await page.addInitScript(() => {
    const decode = OfflineAudioContext.prototype.decodeAudioData;
    const go = new Promise((resolve) => Object.assign(globalThis, { go: resolve }));
    OfflineAudioContext.prototype.decodeAudioData = async function (bytes) {
      await go;
      return decode.call(this, bytes);
    };
  });
  await open(page, 'sounds.webm');
  const button = page.getByRole('button', { name: 'Sounds in the video', exact: true });
  await button.click();
  await expect(page.getByRole('progressbar', { name: 'Reading the sound…' })).toBeVisible();
  await accessible(page);
  await page.getByRole('button', { name: 'Stop analysis' }).click();
  await expect(page.getByRole('progressbar', { name: 'Reading the sound…' })).toHaveCount(0);
  await expect(list(page)).toHaveCount(0);
  await page.evaluate(() => /** @type {any} */ (globalThis).go());
  await button.click();
  await expect(list(page)).toBeVisible();
});
