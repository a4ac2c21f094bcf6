// @ts-check
/** The npm package in an empty project: `cargo xtask test package`. */

export default {
  testDir: '.',
  outputDir: '../results/package',
  workers: 1,
  timeout: 120_000,
  reporter: [['list']],
  forbidOnly: !!process.env.CI,
  use: {
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
    },
  },
};
