// @ts-check
/** The headers in `_headers` match the meta elements of the page. */

import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { headersOfAll } from './host-headers.js';
import { filesOf } from './site-files.js';

const read = (/** @type {string} */ path) => readFile(new URL(path, import.meta.url), 'utf8');
const headers = async () => headersOfAll(await read('./public/_headers'));

test('the policy of the headers is that of the page, and forbids frames of other sites besides', async () => {
  const policy = /http-equiv="Content-Security-Policy"\s+content="([^"]+)"/.exec(await read('./index.html'))?.[1];
  const { 'Content-Security-Policy': sent, 'X-Frame-Options': frames } = await headers();
  expect(sent).toBe(`${policy}; frame-ancestors 'self'`);
  // Browsers ignore it in a meta element.
  expect(policy).not.toContain('frame-ancestors');
  expect(frames).toBe('SAMEORIGIN');
});

test('nginx is told the same', async () => {
  const conf = await read('../docs/reference/nginx.conf');
  const told = Object.fromEntries(
    [...conf.matchAll(/^ {4}add_header (\S+) "(.*)" always;$/gm)].map(([, name, value]) => [name, value]),
  );
  expect(told).toEqual(await headers());
});

test('headers are read as hosts read them', () => {
  expect(headersOfAll('# a: b\n/*\n  X-One: 1: 2\n\n\tX-Two: 3\n/other\n  X-Three: 4\n')).toEqual({
    'X-One': '1: 2',
    'X-Two': '3',
  });
});

test('the file is not among those that the service worker keeps: hosts that read it do not give it away', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'inkpanel-files-'));
  await mkdir(join(folder, 'assets'));
  await Promise.all(['_headers', 'index.html', 'assets/index-x.js'].map((path) => writeFile(join(folder, path), path)));
  const { needed, extras, onUse } = await filesOf(folder);
  expect(
    [...needed, ...extras]
      .map(([path]) => path)
      .concat(onUse)
      .sort(),
  ).toEqual(['', 'assets/index-x.js']);
  await rm(folder, { recursive: true });
});
