// @ts-check
/** The Content-Security-Policy: it blocks other hosts, and nothing that the app does. */

import { readFile } from 'node:fs/promises';
import { addBlock, drawn } from '../style-designer.js';
import { add, detectingTest, expect, idle, press, test } from '../support.js';
import { write } from '../text-items.js';

/** @typedef {import('../support.js').Page} Page */

const FILM = new URL('../../../videos/album.mp4', import.meta.url);
const film = async () => ({ name: 'album.mp4', mimeType: 'video/mp4', buffer: await readFile(FILM) });

/** Collects violations of the policy, from the first script on. @param {Page} page */
async function watchPolicy(page) {
  /** @type {string[]} */
  const violations = [];
  await page.exposeFunction('forbidden', (/** @type {string} */ what) => violations.push(what));
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI }) => {
      /** @type {any} */ (window).forbidden(`${effectiveDirective} ${blockedURI}`);
    });
  });
  return violations;
}

detectingTest('the policy blocks nothing that the app does', async ({ page }) => {
  const violations = await watchPolicy(page);
  await page.goto('./');
  await page.getByRole('button', { name: 'Try the sample album' }).click();
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await add(page, [await film()]);
  await idle(page);
  await press(page, 'Shuffle');
  await press(page, 'Show subjects');
  await write(page, 'balloon', 'HELLO');
  await page.getByRole('button', { name: 'Style designer', exact: true }).click();
  await drawn(page);
  await addBlock(page, 'Sobel');
  await page.getByRole('button', { name: 'Explore styles', exact: true }).click();
  await page
    .getByRole('region', { name: 'Style explorer' })
    .getByRole('button', { name: 'Generate', exact: true })
    .click();
  await expect(page.getByRole('region', { name: 'Style explorer' }).getByRole('listitem')).not.toHaveCount(0);
  await page.getByRole('button', { name: 'Back to the page' }).click();
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  await page.getByRole('button', { name: 'Projects' }).click();
  await expect(
    page.getByRole('region', { name: 'Projects' }).getByRole('img').or(page.locator('.project-picture img')),
  ).not.toHaveCount(0);
  expect(violations).toEqual([]);
});

test('without a video decoder, a video is read by the video element', async ({ page }) => {
  const violations = await watchPolicy(page);
  await page.route('**/video-worker-*.js', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `delete globalThis.VideoDecoder;${await response.text()}` });
  });
  await page.goto('./');
  await add(page, [await film()]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await expect(page.getByRole('checkbox', { name: /^Use album/ })).toHaveCount(24);
  expect(violations).toEqual([]);
});

test('the policy blocks all requests to other hosts', async ({ context }) => {
  /** @type {string[]} */
  const asked = [];
  await context.route('https://elsewhere.test/**', (route) => {
    asked.push(route.request().url());
    return route.abort();
  });
  const silent = await context.newPage();
  const violations = await watchPolicy(silent);
  await silent.goto('./');
  await silent.evaluate(async () => {
    const other = 'https://elsewhere.test/';
    await fetch(`${other}fetch`).catch(() => {});
    navigator.sendBeacon(`${other}beacon`);
    for (const [tag, field] of [
      ['img', 'src'],
      ['script', 'src'],
      ['iframe', 'src'],
      ['video', 'src'],
      ['link', 'href'],
    ]) {
      document.head.append(
        Object.assign(document.createElement(tag), { [field]: `${other}${tag}`, rel: 'stylesheet' }),
      );
    }
    const form = Object.assign(document.createElement('form'), { action: `${other}form`, method: 'post' });
    document.body.append(form);
    form.submit();
    const inline = Object.assign(document.createElement('script'), { textContent: 'window.ran = true' });
    document.head.append(inline);
    // Later, because the policy allows code that a test evaluates.
    setTimeout(() => {
      try {
        (0, eval)('window.ran = true');
      } catch {
        // The policy blocks it.
      }
    });
  });
  await expect
    .poll(() => [...new Set(violations.map((text) => text.split(' ')[0]))].sort())
    .toEqual([
      'connect-src',
      'form-action',
      'frame-src',
      'img-src',
      'media-src',
      'script-src',
      'script-src-elem',
      'style-src-elem',
    ]);
  expect(await silent.evaluate(() => 'ran' in window)).toBe(false);
  expect(asked).toEqual([]);
});
