// @ts-check
/**
 * Runs Ace, the EPUB accessibility checker of DAISY, and prints one line per finding. Exit code 1 if one is serious or
 * critical. Ace renders every page in the Chromium that `PUPPETEER_EXECUTABLE_PATH` names.
 *
 *     PUPPETEER_EXECUTABLE_PATH=/usr/bin/chromium node tests/ace/check.js BOOK.epub ...
 */

import { createRequire } from 'node:module';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const require = createRequire(import.meta.url);
require('@daisy/ace-logger').initLogger({ silent: true });
const ace = require('@daisy/ace-core');
const runner = require('@daisy/ace-axe-runner-puppeteer');

const SERIOUS = ['serious', 'critical'];

const folder = await mkdtemp(join(tmpdir(), 'inkpanel-ace-'));
try {
  for (const [i, book] of process.argv.slice(2).entries()) {
    const [outdir, scratch] = ['out', 'scratch'].map((kind) => join(folder, `${kind}-${i}`));
    await ace(resolve(book), { outdir, tmpdir: scratch, silent: true }, runner);
    const report = require(join(outdir, 'report.json'));
    for (const page of report.assertions)
      for (const found of page.assertions) {
        const { 'earl:impact': impact, 'dct:title': rule } = found['earl:test'];
        console.log([book, page['earl:testSubject'].url, impact, rule].join('\t'));
        if (SERIOUS.includes(impact)) process.exitCode = 1;
      }
    console.log([book, 'checked', report['earl:result']['earl:outcome']].join('\t'));
  }
} finally {
  await rm(folder, { recursive: true, force: true });
}
