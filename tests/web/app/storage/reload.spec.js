// @ts-check
/**
 * Work after a reload, a crash and full storage, in two tabs, and in projects and project files.
 */

import { saved } from '../export-dialog.js';
import { SIX, accessible, contents, drop, expect, idle, openBoard, photos, press, test } from '../support.js';
import { expectSaved } from '../project-files.js';

/** @typedef {import('../support.js').Page} Page */

/** @param {Page} page */
const panels = (page) => page.getByRole('region', { name: 'Comic page' }).getByRole('group', { name: /^Panel \d/ });

test('the page, the project name, favourites and the undo history remain after a reload', async ({ page }) => {
  await openBoard(page);
  await press(page, 'Shuffle');
  await page.getByLabel('Project name').fill('Summer');
  await page.keyboard.press('Enter');
  await press(page, 'Shuffle');
  await page.getByRole('button', { name: 'Favourite page' }).click();
  await expectSaved(page);
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

test('the work remains after a crash during a shuffle and its saving', async ({ page, context }) => {
  await openBoard(page);
  await expectSaved(page);
  const before = await contents(page);
  const session = await context.newCDPSession(page);
  const saving = page.evaluate(
    () =>
      new Promise((resolve) => {
        const look = () => document.querySelector('.save-state[data-state=saving]') && resolve(true);
        new MutationObserver(look).observe(document.body, { subtree: true, childList: true, attributes: true });
      }),
  );
  await page.keyboard.press('s');
  await saving;
  const died = page.waitForEvent('crash');
  // A crashed page does not answer.
  void session.send('Page.crash').catch(() => {});
  await died;
  const again = await context.newPage();
  await again.goto('./');
  await idle(again);
  await expect(panels(again)).toHaveCount(before.photos.length);
  const after = await contents(again);
  expect(after.photos).toEqual(before.photos);
  await press(again, 'Shuffle');
  await expectSaved(again);
});

test('full storage is reported once, and the page remains', async ({ page, context }) => {
  await page.clock.install();
  await openBoard(page, SIX.slice(0, 2));
  await expectSaved(page);
  const session = await context.newCDPSession(page);
  const { origin } = new URL(page.url());
  await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 1 });
  const alert = page.getByRole('alert').getByText('Your work is not saved');
  // The browser checks the quota from time to time.
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
  await page.clock.runFor(10_000);
  await idle(page);
  await expect(alert).toBeHidden();
  await press(page, 'Undo');
  expect(await contents(page)).toEqual(before);
  await session.send('Storage.overrideQuotaForOrigin', { origin });
  await expect(async () => {
    await press(page, 'Shuffle');
    await expect(page.locator('.save-state')).toHaveText('Saved', { timeout: 2000 });
  }).toPass();
});

test('a second tab offers a copy, and opens the project when the first tab is closed', async ({ page, context }) => {
  await openBoard(page, SIX.slice(0, 3));
  await page.getByLabel('Project name').fill('Shared');
  await page.keyboard.press('Enter');
  await expectSaved(page);
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

test('projects are created, opened, deleted and restored', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  await page.getByLabel('Project name').fill('One');
  await page.keyboard.press('Enter');
  await expectSaved(page);
  await page.getByRole('button', { name: 'Projects' }).click();
  await page.getByRole('button', { name: 'New project' }).click();
  await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
  await page.getByRole('button', { name: 'Projects' }).click();
  const region = page.getByRole('region', { name: 'Projects' });
  await region.getByRole('button', { name: 'Delete One' }).click();
  await expect(region.getByRole('button', { name: 'Open One' })).toBeHidden();
  await page.getByRole('button', { name: 'Restore' }).click();
  await region.getByRole('button', { name: 'Open One' }).click();
  await idle(page);
  await expect(page.getByLabel('Project name')).toHaveValue('One');
  await expect(panels(page)).toHaveCount(2);
});

test('a project is saved in a file and opened by a drop on the window', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  await press(page, 'Shuffle');
  await expectSaved(page);
  const before = await contents(page);
  await page.getByLabel('Project name').fill('Back home');
  await page.getByRole('button', { name: 'Projects' }).click();
  const { bytes: buffer } = await saved(page, () => page.getByRole('button', { name: 'Save project' }).click());
  await page.getByRole('button', { name: 'New project' }).click();
  await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
  await drop(page, [{ name: 'back.inkpanel', mimeType: 'application/zip', buffer }]);
  await idle(page);
  await expect(panels(page)).toHaveCount(before.photos.length);
  expect(await contents(page)).toEqual(before);
  await expect(page.getByLabel('Project name')).toHaveValue('Back home');
  await expectSaved(page);
  await drop(page, [
    { name: 'bad.inkpanel', mimeType: 'application/zip', buffer: buffer.subarray(0, buffer.length / 2) },
  ]);
  await expect(page.getByRole('alert').getByText('bad.inkpanel could not be opened')).toBeVisible();
  expect(await contents(page)).toEqual(before);
});

test('the list of versions opens a version, and shows favourites and where a version comes from', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 4));
  const first = await contents(page);
  await press(page, 'Shuffle');
  await press(page, 'Shuffle');
  await page.getByRole('button', { name: 'Favourite page' }).click();
  await page.getByRole('button', { name: /^Page history/ }).click();
  const wall = page.getByRole('region', { name: 'Page history' });
  await expect(wall.getByRole('button', { name: /^Version \d+$/ })).toHaveCount(3);
  await wall.getByRole('button', { name: 'Version 1', exact: true }).click();
  await idle(page);
  expect(await contents(page)).toEqual(first);
  await press(page, 'Shuffle');
  await page.getByRole('button', { name: /^Page history/ }).click();
  await expect(wall.getByText('from version 1')).toBeVisible();
  // Two versions are compared side by side.
  await wall.getByRole('button', { name: 'Compare version 1', exact: true }).click();
  await expect(wall.getByRole('status')).toHaveText('Select the second version to compare');
  expect((await wall.getByRole('status').boundingBox())?.height).toBeGreaterThan(10);
  await expect(wall.getByRole('listitem').first()).toHaveCSS('outline-style', 'solid');
  await expect(wall.getByRole('listitem').nth(1)).toHaveCSS('outline-style', 'none');
  await wall.getByRole('button', { name: 'Cancel' }).click();
  await expect(wall.getByRole('listitem').first()).toHaveCSS('outline-style', 'none');
  await wall.getByRole('button', { name: 'Compare version 1', exact: true }).click();
  await wall.getByRole('button', { name: 'Compare version 3', exact: true }).click();
  await expect(wall.getByRole('button', { name: /^Version \d+$/ })).toHaveCount(2);
  await expect(wall.locator('[data-drawn=true]')).toHaveCount(2);
  const [one, other] = await Promise.all([0, 1].map((n) => wall.locator('.shown-picture').nth(n).boundingBox()));
  expect(one?.height).toBeGreaterThan(400);
  expect(other?.x).toBeGreaterThan((one?.x ?? 0) + (one?.width ?? 0));
  await accessible(page);
  await wall.getByRole('button', { name: 'Show all versions' }).click();
  await wall.getByRole('button', { name: 'Favourites only' }).click();
  await expect(wall.getByRole('button', { name: /^Version \d+$/ })).toHaveCount(1);
});

test('fifty photos are opened again after a reload', { tag: '@ci' }, async ({ page }) => {
  const six = await photos(...SIX);
  const fifty = Array.from({ length: 50 }, (_, i) => ({ ...six[i % 6], name: `photo${i}.jpg` }));
  await page.goto('./');
  await page.getByLabel('Photos or video').setInputFiles(fifty);
  await idle(page);
  await expectSaved(page);
  await page.reload();
  await idle(page);
  // The time is reported and not checked.
  const time = await page.evaluate(() => Math.round(performance.now()));
  test.info().annotations.push({ type: 'ms until the page is back', description: String(time) });
  console.log(`back after ${time} ms`);
  await expect(page.getByRole('region', { name: 'Photos' }).getByRole('checkbox')).toHaveCount(50);
});
