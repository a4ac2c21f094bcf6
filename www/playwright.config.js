// @ts-check
import { defineConfig } from '@playwright/test';
import { CHROMIUM, servedSite } from '../tests/web/launching.js';

const site = servedSite(4187);

export default defineConfig({
  testDir: '../tests/web/app',
  outputDir: '../tests/web/results',
  fullyParallel: false,
  // A page that waits for a timer, a message or one worker leaves cores idle: two files run side by side, even on two cores.
  workers: 2,
  // The machine may be busy: a limit ends what hangs, it does not measure.
  timeout: 240_000,
  expect: { timeout: 30_000 },
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: {
    baseURL: site.url,
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    // What a worker serves no test can stand in the way of; `offline.spec.js` is about it, and allows it.
    serviceWorkers: 'block',
    trace: 'retain-on-failure',
    launchOptions: CHROMIUM,
  },
  webServer: site.webServer,
});
