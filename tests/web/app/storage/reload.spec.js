// @ts-check
/**
 * Nothing is lost: a page that is loaded again, that crashes, whose storage is full, and that is open twice.
 */

import { readFile } from 'node:fs/promises';
import { SIX, contents, drop, expect, idle, openBoard, photos, press, test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** @param {Page} page */
const saved = (page) => expect(page.locator('.save-state')).toHaveText('Saved');
/** @param {Page} page */
const panels = (page) =>
  page.getByRole('region', { name: 'Storyboard page' }).getByRole('group', { name: /^Panel \d/ });

test('everything is there after the page is loaded again, undo too', async ({ page }) => {
  await openBoard(page);
  await press(page, 'Shuffle');
  await page.getByLabel('Project name').fill('Summer');
  await page.keyboard.press('Enter');
  await press(page, 'Shuffle');
  await page.getByRole('button', { name: 'Favourite page' }).click();
  await saved(page);
  const before = await contents(page);
  await page.reload();
  await idle(page);
  expect(await contents(page)).toEqual(before);
  await expect(page.getByLabel('Project name')).toHaveValue('Summer');
  await expect(page.getByRole('button', { name: 'Favourite page' })).toHaveAttribute('aria-pressed', 'true');
  await press(page, 'Undo');
  await press(page, 'Undo');
  expect(await contents(page)).not.toEqual(before);
  await press(page, 'Redo');
  await press(page, 'Redo');
  expect(await contents(page)).toEqual(before);
});

test('a page that dies in the middle of a shuffle and of a save comes back', async ({ page, context }) => {
  await openBoard(page);
  await saved(page);
  const before = await contents(page);
  const session = await context.newCDPSession(page);
  await page.keyboard.press('s');
  // The shuffle is being drawn and its saving begins.
  await page.waitForTimeout(260);
  const died = page.waitForEvent('crash');
  // A page that has crashed answers no more.
  void session.send('Page.crash').catch(() => {});
  await died;
  const again = await context.newPage();
  await again.goto('./');
  await idle(again);
  await expect(panels(again)).toHaveCount(before.photos.length);
  const after = await contents(again);
  expect(after.photos).toEqual(before.photos);
  await press(again, 'Shuffle');
  await saved(again);
});

test('storage that is full is said once, and nothing on the page is lost', async ({ page, context }) => {
  await openBoard(page, SIX.slice(0, 2));
  await saved(page);
  const session = await context.newCDPSession(page);
  const { origin } = new URL(page.url());
  await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 1 });
  const alert = page.getByRole('alert').getByText('Your work is not saved');
  // The browser looks at the quota now and then only.
  await expect(async () => {
    await press(page, 'Shuffle');
    await expect(alert).toBeVisible({ timeout: 2000 });
  }).toPass();
  await expect(page.getByRole('button', { name: 'Not saved' })).toBeVisible();
  const download = page.waitForEvent('download');
  await page.getByRole('alert').getByRole('button', { name: 'Save to file' }).click();
  expect((await download).suggestedFilename()).toMatch(/\.inkpanel$/);
  const before = await contents(page);
  await press(page, 'Shuffle');
  await page.waitForTimeout(1500);
  await expect(alert).toBeHidden();
  await press(page, 'Undo');
  expect(await contents(page)).toEqual(before);
  await session.send('Storage.overrideQuotaForOrigin', { origin });
  await expect(async () => {
    await press(page, 'Shuffle');
    await expect(page.locator('.save-state')).toHaveText('Saved', { timeout: 2000 });
  }).toPass();
});

test('a second tab offers a copy, and opens the project when the first is closed', async ({ page, context }) => {
  await openBoard(page, SIX.slice(0, 3));
  await page.getByLabel('Project name').fill('Shared');
  await page.keyboard.press('Enter');
  await saved(page);
  const second = await context.newPage();
  await second.goto('./');
  await expect(second.getByText('Shared is open in another tab.')).toBeVisible();
  const third = await context.newPage();
  await third.goto('./');
  await third.getByRole('button', { name: 'Open a copy' }).click();
  await idle(third);
  await expect(third.getByLabel('Project name')).toHaveValue('Shared copy');
  await page.close();
  await idle(second);
  await expect(second.getByLabel('Project name')).toHaveValue('Shared');
  await expect(panels(second)).toHaveCount(3);
});

test('projects are made, opened, deleted and brought back', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  await page.getByLabel('Project name').fill('One');
  await page.keyboard.press('Enter');
  await saved(page);
  await page.getByRole('button', { name: 'Projects' }).click();
  await page.getByRole('button', { name: 'New project' }).click();
  await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
  await page.getByRole('button', { name: 'Projects' }).click();
  const region = page.getByRole('region', { name: 'Projects' });
  await region.getByRole('button', { name: 'Delete One' }).click();
  await expect(region.getByRole('button', { name: 'Open One' })).toBeHidden();
  await page.getByRole('button', { name: 'Bring it back' }).click();
  await region.getByRole('button', { name: 'Open One' }).click();
  await idle(page);
  await expect(page.getByLabel('Project name')).toHaveValue('One');
  await expect(panels(page)).toHaveCount(2);
});

test('a project goes into a file and comes back when it is dropped on the window', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  await press(page, 'Shuffle');
  await saved(page);
  const before = await contents(page);
  await page.getByLabel('Project name').fill('Back home');
  await page.getByRole('button', { name: 'Projects' }).click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save project' }).click();
  const buffer = await readFile(await (await download).path());
  await page.getByRole('button', { name: 'New project' }).click();
  await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
  await drop(page, [{ name: 'back.inkpanel', mimeType: 'application/zip', buffer }]);
  await idle(page);
  await expect(panels(page)).toHaveCount(before.photos.length);
  expect(await contents(page)).toEqual(before);
  await expect(page.getByLabel('Project name')).toHaveValue('Back home');
  await saved(page);
  await drop(page, [
    { name: 'bad.inkpanel', mimeType: 'application/zip', buffer: buffer.subarray(0, buffer.length / 2) },
  ]);
  await expect(page.getByRole('alert').getByText('bad.inkpanel could not be opened')).toBeVisible();
  expect(await contents(page)).toEqual(before);
});

test('the pages shown are a wall: back to one, and on from there', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 4));
  const first = await contents(page);
  await press(page, 'Shuffle');
  await press(page, 'Shuffle');
  await page.getByRole('button', { name: 'Favourite page' }).click();
  await page.getByRole('button', { name: /^Pages shown/ }).click();
  const wall = page.getByRole('region', { name: 'Pages shown' });
  await expect(wall.getByRole('button', { name: /^Page \d+$/ })).toHaveCount(3);
  await wall.getByRole('button', { name: 'Page 1', exact: true }).click();
  await idle(page);
  expect(await contents(page)).toEqual(first);
  await press(page, 'Shuffle');
  await page.getByRole('button', { name: /^Pages shown/ }).click();
  await expect(wall.getByText('from page 1')).toBeVisible();
  await wall.getByRole('button', { name: 'Favourites only' }).click();
  await expect(wall.getByRole('button', { name: /^Page \d+$/ })).toHaveCount(1);
});

test('fifty photos are back within two seconds', async ({ page }) => {
  const six = await photos(...SIX);
  const fifty = Array.from({ length: 50 }, (_, i) => ({ ...six[i % 6], name: `photo${i}.jpg` }));
  await page.goto('./');
  await page.getByLabel('Photos or video').setInputFiles(fifty);
  await idle(page);
  await expect(page.locator('.save-state')).toHaveText('Saved', { timeout: 120_000 });
  await page.reload();
  await idle(page);
  // A timing is told, not asserted.
  const time = await page.evaluate(() => Math.round(performance.now()));
  test.info().annotations.push({ type: 'ms until the page is back', description: String(time) });
  console.log(`back after ${time} ms`);
  await expect(page.getByRole('region', { name: 'Photos' }).getByRole('checkbox')).toHaveCount(50);
});
