// @ts-check
/** What times the page in three engines is a test by its form alone: Playwright reads the helpers of the tests, which are TypeScript. */

import { CHROMIUM } from '../tests/web/launching.js';
import { defineConfig } from '../www/testing.ts';

export default defineConfig({
  testDir: '.',
  testMatch: 'engines.spec.js',
  outputDir: '../tests/web/results/bench-engines',
  workers: 1,
  timeout: 3_600_000,
  reporter: [['line']],
  use: { launchOptions: CHROMIUM },
});
