// @ts-check
/** An empty project with the package in it, and a server of its files that knows nothing of bundlers. */

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { TYPES } from '../../../www/content-types.js';

/** @returns {{ folder: string, installed: string, remove: () => void }} `installed` is the package's folder in it */
export function emptyProject() {
  const tarball = process.env.INKPANEL_PACKAGE;
  if (!tarball) throw new Error('INKPANEL_PACKAGE must name the packed package: run `cargo xtask test package`');
  const folder = mkdtempSync(join(tmpdir(), 'inkpanel-project-'));
  writeFileSync(join(folder, 'package.json'), '{ "private": true }');
  // It needs no other package, so no registry is asked.
  const install = ['install', '--offline', '--no-audit', '--no-fund', '--silent', tarball];
  execFileSync(process.platform === 'win32' ? 'npm.cmd' : 'npm', install, { cwd: folder, stdio: 'inherit' });
  return {
    folder,
    installed: join(folder, 'node_modules/inkpanel'),
    remove: () => rmSync(folder, { recursive: true }),
  };
}

/**
 * @param {string} folder
 * @returns {Promise<{ address: string, missing: string[], close: () => void }>} `missing`: requests for missing files
 */
export async function serve(folder) {
  /** @type {string[]} */
  const missing = [];
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://host');
    const file = join(folder, pathname);
    if (!statSync(file, { throwIfNoEntry: false })?.isFile()) {
      missing.push(pathname);
      response.writeHead(404).end();
      return;
    }
    response
      .writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' })
      .end(readFileSync(file));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return { address: `http://127.0.0.1:${port}/`, missing, close: () => server.close() };
}
