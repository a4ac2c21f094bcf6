// @ts-check
import { defineConfig } from '@playwright/test';
import { CHROMIUM, servedSite } from '../tests/web/launching.js';

const site = servedSite(4187);

/** Specs that take more than half a minute. */
const LONG =
  /\/(access|explorer|explorer-wall|hostile|languages|locked-out|masks|screens|sights|subject-brush)\.spec\.js$/;

/** Tags of the tests that a tier of `cargo xtask test` leaves out. A run by hand is like that of a push. */
const LEFT_OUT = { change: /@ci|@nightly/, ci: /@nightly/, all: undefined };
const tier = /** @type {keyof typeof LEFT_OUT} */ (process.env.INKPANEL_TIER ?? 'ci');
if (!(tier in LEFT_OUT))
  throw new Error(`INKPANEL_TIER: ${tier} is not a tier; use ${Object.keys(LEFT_OUT).join(', ')}`);

export default defineConfig({
  testDir: '../tests/web/app',
  outputDir: '../tests/web/results',
  fullyParallel: false,
  grepInvert: LEFT_OUT[tier],
  // Files start in the order of the projects. A long file that starts late would run alone at the end.
  projects: [
    { name: 'long', testMatch: LONG },
    { name: 'short', testIgnore: LONG },
  ],
  // A page that waits for a timer, a message or a worker leaves cores idle: two files run in parallel, even on two cores.
  workers: 2,
  // The machine may be busy. A limit ends a test that hangs; it measures nothing.
  timeout: 240_000,
  expect: { timeout: 30_000 },
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  retries: 0,
  use: {
    baseURL: site.url,
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    // Responses of a service worker cannot be changed by a test. `offline.spec.js` allows it.
    serviceWorkers: 'block',
    // Screenshots and snapshots of every step take a third of the time of the tests.
    trace: { mode: 'retain-on-failure', screenshots: false, snapshots: false, sources: false },
    screenshot: 'only-on-failure',
    launchOptions: CHROMIUM,
  },
  webServer: site.webServer,
});
