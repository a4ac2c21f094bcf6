// @ts-check
import { defineConfig } from '@playwright/test';

/** The built site is served below a path, so that an absolute address anywhere in it fails the tests. */
const PATH = '/some/sub/path/';
const PORT = Number(process.env.INKPANEL_TEST_PORT ?? 4187);

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
    baseURL: `http://127.0.0.1:${PORT}${PATH}`,
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    // What a worker serves no test can stand in the way of; `offline.spec.js` is about it, and allows it.
    serviceWorkers: 'block',
    trace: 'retain-on-failure',
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: [
        '--no-sandbox',
        '--disable-gpu',
        '--disable-quic',
        '--no-first-run',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
      ],
    },
  },
  webServer: {
    command: `node serve.js ${PORT} ${PATH}`,
    url: `http://127.0.0.1:${PORT}${PATH}`,
    reuseExistingServer: false,
  },
});
