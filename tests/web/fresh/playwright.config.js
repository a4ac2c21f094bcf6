// @ts-check
/** The page that `cargo xtask serve` serves from a fresh checkout: `cargo xtask test fresh`. */

import { CHROMIUM } from '../launching.js';

export default {
  testDir: '.',
  outputDir: '../results/fresh',
  workers: 1,
  timeout: 600_000,
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: { baseURL: process.env.INKPANEL_ADDRESS, launchOptions: CHROMIUM, acceptDownloads: true },
};
