// @ts-check
/**
 * Configuration for measuring the app in three browser engines. It runs as a Playwright test, because the helpers of
 * the tests are TypeScript, which Playwright compiles.
 */

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
