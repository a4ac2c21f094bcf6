// @ts-check
/** Steps of the tests without a connection. */

import { test as plain } from '../../../www/testing.ts';
import { expect } from './support.js';
import { remove, startHost } from './site-host.js';

/** @typedef {import('../../../www/testing.ts').Page} Page */
/** @typedef {import('../../../www/testing.ts').Context} Context */
/** @typedef {Awaited<ReturnType<typeof startHost>>} Host */

/**
 * A test with its own host, and with service workers. A request to another origin fails the test. A request without an
 * answer does not.
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

/** Waits until the files of the app are cached. @param {Page} page */
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

/** Waits until the module and the models of the detectors are cached, some time after their first use. @param {Page} page */
export async function netsKept(page) {
  const kept = () =>
    page.evaluate(async () => (await (await caches.open('inkpanel-nets')).keys()).map(({ url }) => url).join(' '));
  // The models of aesthetics and subjects may be cached by then or not.
  for (const name of [/\/nets-\w+\.wasm/, /\/faces-/, /\/objects-/])
    await expect.poll(kept, { timeout: 30_000 }).toMatch(name);
}

/** The number of cached builds. @param {Page} page */
export const builds = (page) =>
  page.evaluate(async () => (await caches.keys()).filter((name) => name.startsWith('inkpanel /')).length);

/** The name of the build of a tab. @param {Page} page */
export const buildOf = (page) => page.evaluate(() => document.documentElement.dataset.build ?? 'first');

/** Lets the browser check for a new version. @param {Page} page */
export async function lookForUpdate(page) {
  await page.evaluate(async () => {
    await (await navigator.serviceWorker.getRegistration())?.update().catch(() => {});
  });
}

/** @param {Page} page */
export const offer = (page) => page.getByRole('status').getByText('A new version is ready.');
