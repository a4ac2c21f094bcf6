// @ts-check
/**
 * Lighthouse on the start of the built site, by its desktop and its mobile profile: `cargo xtask bench lighthouse`
 * starts it. Prints the scores, in hundredths, and the times that they come from.
 */

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { launch } from 'chrome-launcher';
import lighthouse, { desktopConfig } from 'lighthouse';
import { CHROMIUM } from '../tests/web/launching.js';

const SITE = new URL('../www/serve.js', import.meta.url).pathname;
const CATEGORIES = ['performance', 'accessibility', 'best-practices'];
/** The lowest score in hundredths that is accepted. */
const LIMITS = { performance: 90, accessibility: 100, 'best-practices': 95 };
const TIMES = ['first-contentful-paint', 'largest-contentful-paint', 'total-blocking-time', 'cumulative-layout-shift'];

// Compressed and without further headers, as static hosts send it. Port 0 is any that is free.
const server = spawn('node', [SITE, '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
const [address] = await once(server.stdout.setEncoding('utf8'), 'data');
const chrome = await launch({
  chromePath: CHROMIUM.executablePath,
  chromeFlags: ['--headless', ...CHROMIUM.args],
  logLevel: 'error',
});
try {
  const rows = [['profile', ...CATEGORIES, ...TIMES]];
  for (const [profile, config] of /** @type {const} */ ([
    ['desktop', desktopConfig],
    ['mobile', undefined],
  ])) {
    const flags = { port: chrome.port, onlyCategories: CATEGORIES, logLevel: /** @type {const} */ ('error') };
    const run = await lighthouse(address.trim(), flags, config);
    if (!run) throw new Error(`Lighthouse tells nothing by the ${profile} profile.`);
    const { categories, audits } = run.lhr;
    rows.push([
      profile,
      ...CATEGORIES.map((id) => String(Math.round((categories[id].score ?? 0) * 100))),
      ...TIMES.map((id) => audits[id].displayValue ?? '-'),
    ]);
  }
  for (const [profile, ...scores] of rows.slice(1)) {
    CATEGORIES.forEach((id, i) => {
      if (Number(scores[i]) >= LIMITS[id]) return;
      console.error(`${profile}: ${id} is ${scores[i]}, at least ${LIMITS[id]} is expected`);
      process.exitCode = 1;
    });
  }
  const lines = rows.map((row) => `| ${row.join(' | ')} |`);
  console.log([lines[0], `|${' --- |'.repeat(rows[0].length)}`, ...lines.slice(1)].join('\n'));
} finally {
  chrome.kill();
  server.kill();
}
