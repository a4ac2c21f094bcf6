// @ts-check
/** The same user flows in three engines. Playwright runs and counts the tests, and WebDriver controls the browsers. */

import { defineConfig } from '../../www/testing.ts';
import { servedSite } from '../web/launching.js';
import { ENGINES } from './engines.js';

const site = servedSite(4287);

export default defineConfig({
  testDir: '.',
  outputDir: '../web/results/engines',
  fullyParallel: true,
  // Two browsers at a time: each has pauses in which the other works.
  workers: 2,
  // The machine may be busy: a limit ends what hangs, it does not measure.
  timeout: 240_000,
  expect: { timeout: 60_000 },
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: { baseURL: site.url },
  projects: [
    ...Object.keys(ENGINES).map((name) => ({
      name,
      testIgnore: 'all-engines.spec.js',
      metadata: { engine: name },
      // JavaScriptCore 2.50 sometimes corrupts running code (docs/design/webkit.md), and clicks of WebDriver can miss.
      // Bugs in the app fail every time.
      ...(name.startsWith('webkit') && { retries: 3 }),
      // A private window differs only in stored data.
      ...(name.endsWith('-private') && { grep: /there again after a reload/ }),
    })),
    { name: 'all', testMatch: 'all-engines.spec.js' },
  ],
  webServer: site.webServer,
});
