// @ts-check
/** The app in frames of other sites, and the headers of the host. */

import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { headersOfAll } from '../../../../www/host-headers.js';
import { savedAs } from '../export-dialog.js';
import { kept } from '../service-worker.js';
import { startHost } from '../site-host.js';
import { accessible, add, expect, faultTest, idle, photos, press, test } from '../support.js';
import { write } from '../text-items.js';

const HEADERS = headersOfAll(await readFile(new URL('../../../../www/public/_headers', import.meta.url), 'utf8'));
const REFUSED = 'Inkpanel does not run inside other websites, to protect you from clickjacking.';

/** Starts another site with a frame. @param {string} inside @param {string} [attributes] of the frame */
async function otherSite(inside, attributes = '') {
  const server = createServer((_, response) =>
    response
      .writeHead(200, { 'content-type': 'text/html' })
      .end(
        `<!doctype html><html lang="en"><title>Other</title><main aria-label="Other"><h1>Other</h1><iframe title="Inside" src="${inside}" ${attributes} width="900" height="600"></iframe></main></html>`,
      ),
  );
  await new Promise((resolve) => {
    server.listen(0, '127.0.0.1', () => resolve(null));
  });
  const about = server.address();
  return {
    address: `http://127.0.0.1:${typeof about === 'object' && about ? about.port : 0}/`,
    close: () => server.close(),
  };
}

faultTest(
  'in a frame of another site the app does not start, and shows a link',
  { tag: '@ci' },
  async ({ page, context, baseURL }) => {
    const asked = /** @type {string[]} */ ([]);
    context.on('request', (request) => asked.push(request.url()));
    const site = await otherSite(`${baseURL}#style=x`);
    await page.goto(site.address);
    const frame = page.frameLocator('iframe');
    await expect(frame.getByText(REFUSED)).toBeVisible();
    await accessible(page);
    // No controls, no worker, no stored data, and no request for the module.
    await expect(frame.locator('input, button')).toHaveCount(0);
    const inner = /** @type {ReturnType<import('../support.js').Page['frames']>[number]} */ (
      page.frames().find((other) => other.url().startsWith(String(baseURL)))
    );
    expect(
      await inner.evaluate(async () => [
        localStorage.length,
        (await indexedDB.databases()).length,
        (await navigator.serviceWorker.getRegistrations()).length,
      ]),
    ).toEqual([0, 0, 0]);
    expect(page.workers()).toEqual([]);
    expect(asked.filter((url) => /\.wasm|worker/.test(url))).toEqual([]);
    const [own] = await Promise.all([
      context.waitForEvent('page'),
      frame.getByRole('link', { name: 'Open Inkpanel in a new tab' }).click(),
    ]);
    await expect(own.getByRole('button', { name: 'Try the sample album' })).toBeVisible();
    expect(await own.evaluate(() => window.opener)).toBe(null);
    site.close();
  },
);

faultTest(
  'the app does not start in a sandboxed frame, and in a nested frame of another site',
  { tag: '@ci' },
  async ({ page, baseURL }) => {
    const boxed = await otherSite(String(baseURL), 'sandbox="allow-scripts"');
    await page.goto(boxed.address);
    // Its scripts have another origin there, and are not loaded.
    await expect(page.frameLocator('iframe').locator('input, button')).toHaveCount(0);
    boxed.close();
    await page.route(`${baseURL}inner.html`, (route) =>
      route.fulfill({
        contentType: 'text/html',
        body: '<!doctype html><title>Inner</title><iframe title="Innermost" src="./"></iframe>',
      }),
    );
    const nested = await otherSite(`${baseURL}inner.html`);
    await page.goto(nested.address);
    await expect(page.frameLocator('iframe').frameLocator('iframe').getByText(REFUSED)).toBeVisible();
    nested.close();
  },
);

test('the app works in a frame of the same origin', { tag: '@ci' }, async ({ page, baseURL }) => {
  await page.route(`${baseURL}frame.html`, (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: '<!doctype html><title>Own</title><iframe title="Inside" src="./" width="1200" height="700"></iframe>',
    }),
  );
  await page.goto('./frame.html');
  const frame = page.frameLocator('iframe');
  await frame.getByLabel('Photos or video').setInputFiles(await photos('cat.jpg', 'bee.jpg'));
  await expect(frame.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await expect(frame.getByRole('group', { name: 'Panel 1 of 2' })).toBeVisible();
});

faultTest.describe('with the headers', () => {
  faultTest.use({ serviceWorkers: 'allow' });

  faultTest(
    'browsers block the app in frames of other sites, and all its functions work, also without a connection',
    { tag: '@ci' },
    async ({ page, context }) => {
      const host = await startHost({ headers: HEADERS });
      const wrong = /** @type {string[]} */ ([]);
      context.on('console', (message) => {
        if (message.type() === 'error') wrong.push(message.text());
      });
      context.on('weberror', (error) => wrong.push(error.error().message));
      await page.goto(host.address);
      await add(page, await photos('cat.jpg', 'bee.jpg'));
      await idle(page);
      await press(page, 'Shuffle');
      await write(page, 'balloon', 'HELLO');
      expect((await savedAs(page, 'pdf')).bytes.subarray(0, 5).toString()).toBe('%PDF-');
      await kept(page);
      expect(wrong).toEqual([]);
      await host.stop();
      await page.reload();
      await idle(page);
      await expect(page.getByRole('group', { name: 'Panel 1 of 2' })).toBeVisible();
      await host.start();
      const site = await otherSite(host.address);
      await page.goto(site.address);
      await expect.poll(() => wrong.join()).toMatch(/frame-ancestors|X-Frame-Options/);
      expect(
        await page
          .frames()[1]
          .evaluate(() => document.getElementById('app') !== null)
          .catch(() => false),
      ).toBe(false);
      site.close();
      await host.stop();
    },
  );
});
