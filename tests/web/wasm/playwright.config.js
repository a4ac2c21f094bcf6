// @ts-check
/** The wasm core alone in a blank page, against the native build: `cargo xtask test wasm`. */

export default {
  testDir: '.',
  outputDir: '../results/wasm',
  workers: 1,
  timeout: 60_000,
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: {
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
    },
  },
};
