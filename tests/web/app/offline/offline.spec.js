// @ts-check
/** The app without a connection, after one visit. */

import { readFile } from 'node:fs/promises';
import { PNG } from '../../../../www/testing.ts';
import { kept, netsKept, test } from '../service-worker.js';
import { SIX, accessible, add, colours, expect, idle, photos, picture, pixelsOf, press, reach } from '../support.js';
import { write } from '../text-items.js';

const WEBP = new URL('../../../oracles/data/files/webp-lossy.webp', import.meta.url);

test('after one visit the app works without its host: sample album, text and PNG file', async ({ page, host }) => {
  await page.goto(host.address);
  await kept(page);
  await host.stop();
  await page.reload();
  await page.getByRole('button', { name: 'Try the sample album' }).click();
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await press(page, 'Shuffle');
  await write(page, 'balloon', 'OFFLINE');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download PNG' }).click();
  const png = PNG.sync.read(await readFile(await (await download).path()));
  expect([png.width, png.height]).toEqual([2480, 3508]);
  expect(colours(png)).toBeGreaterThan(2);
  // The WebP decoder was not loaded before.
  const webp = { name: 'still.webp', mimeType: 'image/webp', buffer: await readFile(WEBP) };
  await add(page, [webp, ...(await photos('cat.jpg'))]);
  await idle(page);
  await expect(page.getByRole('checkbox', { name: 'Use still.webp' })).toHaveCount(1);
  await expect(page.getByRole('alert')).toHaveText('');
  await host.start();
});

test.describe('in German', () => {
  test.use({ locale: 'de-AT' });

  test('all languages work without the host', async ({ page, host }) => {
    await page.goto(host.address);
    await kept(page);
    await host.stop();
    await page.reload();
    await expect(page.getByRole('button', { name: 'Beispielalbum ausprobieren' })).toBeVisible();
    await page.getByRole('combobox', { name: 'Sprache' }).selectOption('ja');
    await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
    await expect(page.getByRole('button', { name: 'サンプルアルバムを試す' })).toBeVisible();
    await host.start();
  });
});

test('no file is requested twice while the first page is made', async ({ page, host }) => {
  await page.goto(host.address);
  await add(page, await photos(...SIX));
  await idle(page);
  expect(host.asked.filter((path) => path.endsWith('.wasm'))).toHaveLength(1);
  expect(host.asked).not.toContain('service-worker.js');
  await kept(page);
  expect(host.asked).toContain('service-worker.js');
  // The cached app requests only the file that announces a new version.
  host.asked.length = 0;
  await page.reload();
  await idle(page);
  expect(host.asked.filter((path) => path !== 'service-worker.js')).toEqual([]);
});

test('faces are detected without a connection after the first detection, and later when the connection is back', {
  tag: '@ci',
}, async ({ page, context, host }) => {
  await page.goto(host.address);
  await kept(page);
  await page.evaluate(() => {
    sessionStorage.setItem('detects', 'yes');
    localStorage.removeItem('inkpanel.detect');
  });
  await context.setOffline(true);
  await page.reload();
  await add(page, await photos('camera.jpg', 'cat.jpg'));
  await idle(page);
  await expect(page.getByText('Until you are online')).toHaveCount(1);
  await context.setOffline(false);
  const boxes = page.locator('.page .subject-boxes rect');
  await (await reach(page, 'Show subjects')).click();
  await expect(boxes).not.toHaveCount(0);
  await idle(page);
  await netsKept(page);
  await host.stop();
  await page.reload();
  await add(page, await photos('horses.jpg'));
  await page.waitForFunction(() => document.body.dataset.detected === 'true');
  await (await reach(page, 'Show subjects')).click();
  await expect(page.locator('.page .subject-boxes rect[data-label="horse"]')).not.toHaveCount(0);
  await expect(page.getByText('Until you are online')).toHaveCount(0);
  await host.start();
});

test('photos shared by another app become a comic page', async ({ page, host, context }) => {
  await page.goto(host.address);
  await kept(page);
  await page.close();
  // The browser posts them without an origin, as this page does.
  const other = await context.newPage();
  await other.setContent(
    `<form method="post" enctype="multipart/form-data" action="${host.address}share"><input type="file" name="files" multiple></form>`,
  );
  await other.locator('input').setInputFiles(await photos('bee.jpg', 'macaw.jpg'));
  await other.locator('form').evaluate((form) => /** @type {HTMLFormElement} */ (form).submit());
  await expect(other.getByRole('checkbox', { name: 'Use macaw.jpg' })).toBeAttached();
  await idle(other);
  expect(other.url()).toBe(host.address);
  expect(colours(pixelsOf(await picture(other)))).toBeGreaterThan(2);
  await expect
    .poll(() => other.evaluate(async () => (await (await caches.open('inkpanel-shared')).keys()).length))
    .toBe(0);
});

test('the manifest is valid, and its icons have the declared sizes', async ({ page, host, context }) => {
  await page.goto(host.address);
  const session = await context.newCDPSession(page);
  const { errors, url } = await session.send('Page.getAppManifest');
  expect(errors).toEqual([]);
  const manifest = JSON.parse(await (await page.request.get(url)).text());
  for (const { src, sizes, type } of manifest.icons) {
    const icon = await page.request.get(new URL(src, url).href);
    expect([icon.status(), icon.headers()['content-type']]).toEqual([200, type]);
    if (type !== 'image/png') continue;
    const { width, height } = PNG.sync.read(await icon.body());
    expect(`${width}x${height}`).toBe(sizes);
  }
  expect(new URL(manifest.start_url, url).href).toBe(host.address);
  expect(new URL(manifest.share_target.action, url).href).toBe(`${host.address}share`);
  await kept(page);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  expect(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== 'in-incognito')).toEqual([]);
});

test('a button installs the app when the browser offers it', async ({ page, host }) => {
  await page.goto(host.address);
  const button = page.getByRole('button', { name: 'Install', exact: true });
  await expect(page.getByRole('button', { name: 'Try the sample album' })).toBeVisible();
  await expect(button).toHaveCount(0);
  await page.evaluate(() => {
    const event = Object.assign(new Event('beforeinstallprompt', { cancelable: true }), {
      prompt: async () => {
        document.body.dataset.asked = String(event.defaultPrevented);
      },
    });
    window.dispatchEvent(event);
  });
  await accessible(page);
  await button.click();
  await expect(page.locator('body')).toHaveAttribute('data-asked', 'true');
  await expect(button).toHaveCount(0);
});
