// @ts-check
/** How tests and the benchmark start Chromium, and how the built site is served to them. */

import { fileURLToPath } from 'node:url';

/** Chromium without prompts and without its own pages. */
export const CHROMIUM = {
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
};

const SERVER = fileURLToPath(new URL('../../www/serve.js', import.meta.url));

/** The built site is served below a path, so that an absolute address anywhere in it fails the tests. */
const PATH = '/some/sub/path/';

/** @param {number} usual port, unless `INKPANEL_TEST_PORT` says another */
export function servedSite(usual) {
  const port = Number(process.env.INKPANEL_TEST_PORT ?? usual);
  const url = `http://127.0.0.1:${port}${PATH}`;
  return { url, webServer: { command: `node ${SERVER} ${port} ${PATH}`, url, reuseExistingServer: false } };
}
