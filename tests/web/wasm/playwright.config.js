// @ts-check
/** The wasm core in a blank page, compared with the native build: `cargo xtask test wasm`. */

import { CHROMIUM } from '../launching.js';

export default {
  testDir: '.',
  outputDir: '../results/wasm',
  workers: 1,
  timeout: 240_000,
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: { launchOptions: CHROMIUM },
};
