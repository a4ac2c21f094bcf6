// @ts-check
/** What the tests of the page without a connection share. */

import { test as plain } from '../../../www/testing.ts';
import { expect } from './support.js';
import { remove, startHost } from './site-host.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {import('../../../www/testing.ts').Context} Context */
/** @typedef {Awaited<ReturnType<typeof startHost>>} Host */

/**
 * A host of its own for each test, whose workers are allowed. A request to another origin fails the test, but not a
 * request that finds no host.
 * @type {import('../../../www/testing.ts').TestWith<{ host: Host, folders: string[] }>} `folders` are removed afterwards
 */
export const test = plain.extend(
  /** @type {any} */ ({
    serviceWorkers: 'allow',
    host: async (/** @type {{}} */ {}, /** @type {(host: Host) => Promise<void>} */ use) => {
      const host = await startHost();
      await use(host);
      await host.stop();
    },
    folders: async (/** @type {{}} */ {}, /** @type {(folders: string[]) => Promise<void>} */ use) => {
      /** @type {string[]} */
      const folders = [];
      await use(folders);
      await Promise.all(folders.map(remove));
    },
    page: async (
      /** @type {{ page: Page, context: Context, host: Host }} */ { page, context, host },
      /** @type {(page: Page) => Promise<void>} */ use,
    ) => {
      await context.addInitScript(() => {
        if (sessionStorage.getItem('detects') !== 'yes') localStorage.setItem('inkpanel.detect', 'off');
      });
      const { origin } = new URL(host.address);
      /** @type {string[]} */
      const wrong = [];
      context.on('request', (request) => {
        const url = new URL(request.url());
        if (!['blob:', 'data:'].includes(url.protocol) && url.origin !== origin) wrong.push(`request to ${url}`);
      });
      page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
      await use(page);
      expect(wrong).toEqual([]);
    },
  }),
);

/** Until the site is kept, the extras too. @param {Page} page */
export async function kept(page) {
  await expect
    .poll(() =>
      page.evaluate(async () => {
        if (!navigator.serviceWorker.controller) return false;
        const names = (await caches.keys()).filter((name) => name.startsWith('inkpanel /'));
        const found = await Promise.all(
          names.map(async (name) =>
            (await caches.open(name)).match(new URL('samples/19-astronaut.jpg', document.baseURI).href),
          ),
        );
        return found.some(Boolean);
      }),
    )
    .toBe(true);
}

/** Until the module of the detectors and their nets are kept, some time after their first use. @param {Page} page */
export async function netsKept(page) {
  const kept = () =>
    page.evaluate(async () => (await (await caches.open('inkpanel-nets')).keys()).map(({ url }) => url).join(' '));
  // The nets that come after them, of beauty and of figures, may be kept by then or not.
  for (const name of [/\/nets-\w+\.wasm/, /\/faces-/, /\/objects-/])
    await expect.poll(kept, { timeout: 30_000 }).toMatch(name);
}

/** The builds that the browser keeps. @param {Page} page */
export const builds = (page) =>
  page.evaluate(async () => (await caches.keys()).filter((name) => name.startsWith('inkpanel /')).length);

/** Which build a page is of. @param {Page} page */
export const buildOf = (page) => page.evaluate(() => document.documentElement.dataset.build ?? 'first');

/** Has the browser look for a new version now. @param {Page} page */
export async function lookForUpdate(page) {
  await page.evaluate(async () => {
    await (await navigator.serviceWorker.getRegistration())?.update().catch(() => {});
  });
}

/** @param {Page} page */
export const offer = (page) => page.getByRole('status').getByText('A new version is ready.');
