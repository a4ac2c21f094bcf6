// @ts-check
import { defineConfig } from '@playwright/test';
import { CHROMIUM, servedSite } from '../tests/web/launching.js';

const site = servedSite(4187);
/** Specs that take minutes. */
const LONG = /(hostile|languages|screens|sights|access|locked-out|traps|animatic|motion|video)\.spec\.js$/;

/** `INKPANEL_PAGE=short` leaves the long specs out and prints their pattern. */
const short = process.env.INKPANEL_PAGE === 'short';
if (short && !process.env.TEST_WORKER_INDEX) console.log(`NOT RUN: specs that match ${LONG}`);

export default defineConfig({
  testDir: '../tests/web/app',
  outputDir: '../tests/web/results',
  fullyParallel: false,
  // Files are begun in the order of their projects: one that takes minutes would leave a worker idle at the end.
  projects: [...(short ? [] : [{ name: 'long', testMatch: LONG }]), { name: 'short', testIgnore: LONG }],
  // A page that waits for a timer, a message or one worker leaves cores idle: two files run side by side, even on two cores.
  workers: 2,
  // The machine may be busy: a limit ends what hangs, it does not measure.
  timeout: 240_000,
  expect: { timeout: 30_000 },
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  // Nobody watches there: a second try brings the trace, and tells a race, which is listed as flaky, from a fault.
  retries: process.env.CI ? 1 : 0,
  use: {
    baseURL: site.url,
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    // What a worker serves no test can stand in the way of; `offline.spec.js` is about it, and allows it.
    serviceWorkers: 'block',
    // Pictures and page contents of every step cost a third of the suite's time: they are kept of a second try alone.
    trace: process.env.CI
      ? 'on-first-retry'
      : { mode: 'retain-on-failure', screenshots: false, snapshots: false, sources: false },
    screenshot: 'only-on-failure',
    launchOptions: CHROMIUM,
  },
  webServer: site.webServer,
});
