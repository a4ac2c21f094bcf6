// @ts-check
/** The core's module in a blank page of an origin that only this test knows. */

import { readFileSync } from 'node:fs';
import { extname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { transformWithOxc } from '../../../www/testing.ts';

/** Secure, as WebCodecs asks for it; nothing listens there. */
const ORIGIN = 'https://core.test';
const WWW = fileURLToPath(new URL('../../../www', import.meta.url));
/** @type {Record<string, string>} */
const TYPES = { '.js': 'text/javascript', '.wasm': 'application/wasm' };

/**
 * Opens the page with the module's exports in the global `core`.
 * @param {import('../../../www/node_modules/@playwright/test').Page} page
 */
export async function openCore(page) {
  await page.route(`${ORIGIN}/**`, async (route) => {
    const { pathname } = new URL(route.request().url());
    if (!/^\/(pkg|pkg-decoders|pkg-detector|pkg-heic|models|engine)\//.test(pathname))
      return route.fulfill({ contentType: 'text/html', body: '<!doctype html>' });
    const body = readFileSync(WWW + pathname);
    if (!pathname.endsWith('.ts')) return route.fulfill({ contentType: TYPES[extname(pathname)], body });
    const { code } = await transformWithOxc(body.toString(), pathname);
    return route.fulfill({ contentType: TYPES['.js'], body: code });
  });
  await page.goto(ORIGIN);
  await page.evaluate(async () => {
    const core = await import(/** @type {any} */ ('/pkg/inkpanel.js'));
    await core.default();
    Object.assign(globalThis, { core });
  });
}
