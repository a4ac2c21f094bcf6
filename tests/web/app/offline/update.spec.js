// @ts-check
/** A new build on the host, while tabs with the previous build are open. */

import { readdir, unlink } from 'node:fs/promises';
import { join } from 'node:path';
import { buildOf, builds, kept, lookForUpdate, offer, test } from '../service-worker.js';
import { anotherBuild } from '../site-host.js';
import { SIX, accessible, add, contents, expect, idle, photos } from '../support.js';
import { word, write } from '../text-items.js';

test('a new version is used after Reload, and a tab with the old version continues with its own files', {
  tag: '@ci',
}, async ({ page, host, folders, context }) => {
  await page.goto(host.address);
  await add(page, await photos(...SIX.slice(0, 3)));
  await idle(page);
  await kept(page);
  const before = await contents(page);
  const old = await context.newPage();
  await old.goto(host.address);
  await add(old, await photos('cat.jpg'));
  await idle(old);
  await expect(old.locator('.save-state')).toHaveText('Saved');
  folders.push(await anotherBuild('second'));
  [host.folder] = folders;
  await lookForUpdate(page);
  await expect(offer(page)).toBeVisible();
  await expect(offer(old)).toBeVisible();
  await accessible(page);
  // Neither time nor a reload changes the version.
  await old.reload();
  expect([await buildOf(page), await buildOf(old)]).toEqual(['first', 'first']);
  await expect(offer(old)).toBeVisible();
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.waitForFunction(() => document.documentElement.dataset.build === 'second');
  await idle(page);
  expect(await contents(page)).toEqual(before);
  // The module of the lettering is loaded now. The host does not have it any more.
  await write(old, 'balloon', 'STILL HERE');
  await expect(word(old, 'Balloon: STILL HERE')).toBeVisible();
  expect(await buildOf(old)).toBe('first');
  await expect(old.getByRole('alert')).toHaveText('');
  await write(page, 'balloon', 'NEW');
  // When the last tab with the old version is closed, its files are deleted.
  expect(await builds(page)).toBe(2);
  await old.close();
  await page.reload();
  await expect.poll(() => builds(page)).toBe(1);
  await host.stop();
  await page.reload();
  await idle(page);
  expect(await buildOf(page)).toBe('second');
  await host.start();
});

test('an incomplete version does not replace the previous one', { tag: '@ci' }, async ({ page, host, folders }) => {
  await page.goto(host.address);
  await kept(page);
  folders.push(await anotherBuild('broken'));
  [host.folder] = folders;
  const assets = join(host.folder, 'assets');
  const [module] = (await readdir(assets)).filter((name) => name.startsWith('inkpanel_bg'));
  await unlink(join(assets, module));
  host.asked.length = 0;
  await lookForUpdate(page);
  await expect.poll(() => host.asked).toContain(`assets/${module}`);
  await page.reload();
  await expect.poll(() => builds(page)).toBe(1);
  await expect(offer(page)).toHaveCount(0);
  expect(await buildOf(page)).toBe('first');
  await host.stop();
  await page.reload();
  await add(page, await photos('cat.jpg'));
  await idle(page);
  expect(await buildOf(page)).toBe('first');
  await host.start();
});

test('a host with the new file list and the old page is tried again', { tag: '@ci' }, async ({
  page,
  host,
  folders,
}) => {
  await page.goto(host.address);
  await kept(page);
  const second = await anotherBuild('second');
  folders.push(second);
  host.folder = second;
  host.stale = ['index.html'];
  await lookForUpdate(page);
  await expect.poll(() => host.asked.filter((path) => path === 'service-worker.js').length).toBeGreaterThan(1);
  await expect.poll(() => builds(page)).toBe(1);
  await expect(offer(page)).toHaveCount(0);
  host.stale = [];
  await lookForUpdate(page);
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.waitForFunction(() => document.documentElement.dataset.build === 'second');
});
