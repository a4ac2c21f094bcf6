// @ts-check
/**
 * What Ace, the accessibility checker of DAISY, says of EPUB files: a line for each thing that it finds, and exit code 1 where
 * one is serious or critical. It looks at every page in a Chromium, which `PUPPETEER_EXECUTABLE_PATH` names.
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
