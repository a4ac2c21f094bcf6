// @ts-check
/** The npm package in an empty project: `cargo xtask test package`. */

import { CHROMIUM } from '../launching.js';

export default {
  testDir: '.',
  outputDir: '../results/package',
  workers: 1,
  timeout: 120_000,
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: { launchOptions: CHROMIUM },
};
