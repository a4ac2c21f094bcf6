// @ts-check
/** A static host that the tests of updates can stop, and that can get another build of the site. */

import { randomBytes } from 'node:crypto';
import { cp, mkdtemp, readFile, readdir, rename, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { TYPES } from '../../../www/content-types.js';
import { sealSite } from '../../../www/site-files.js';

export const BUILT = fileURLToPath(new URL('../../../www/dist/', import.meta.url));
const BASE = '/a/folder/';
const TEXTS = ['.js', '.css', '.html'];

/**
 * Starts with the built site; of the files in `stale` it goes on with the old ones.
 * @param {{ headers?: Record<string, string> }} [how] `headers` of every file, as of a host that reads `_headers` and keeps that for itself
 */
export async function startHost({ headers } = {}) {
  const host = {
    folder: BUILT,
    address: '',
    stop,
    start,
    asked: /** @type {string[]} */ ([]),
    stale: /** @type {string[]} */ ([]),
  };
  let port = 0;
  /** @type {import('node:http').Server} */
  let server;
  await start();
  return host;

  async function start() {
    server = createServer(async ({ url = '/' }, response) => {
      const path = decodeURIComponent(new URL(url, 'http://host').pathname).slice(BASE.length) || 'index.html';
      host.asked.push(path);
      const bytes =
        headers && path === '_headers'
          ? null
          : await readFile(join(host.stale.includes(path) ? BUILT : host.folder, path)).catch(() => null);
      if (!bytes) return response.writeHead(404).end();
      return response
        .writeHead(200, { ...headers, 'content-type': TYPES[extname(path)] ?? 'application/octet-stream' })
        .end(bytes);
    });
    await new Promise((resolve) => {
      server.listen(port, '127.0.0.1', () => resolve(null));
    });
    const about = server.address();
    port = typeof about === 'object' && about ? about.port : 0;
    host.address = `http://127.0.0.1:${port}${BASE}`;
  }

  async function stop() {
    server.closeAllConnections();
    await new Promise((resolve) => {
      server.close(resolve);
    });
  }
}

/**
 * Makes another build of the same site. No file in `assets` has its old name, so the host has no old files.
 * `data-build` of the page names the build.
 * @param {string} name
 * @param {(folder: string) => Promise<void>} [change] before its files are listed
 * @returns {Promise<string>} its folder, to be removed
 */
export async function anotherBuild(name, change = async () => {}) {
  const folder = await mkdtemp(join(tmpdir(), 'inkpanel-build-'));
  await cp(BUILT, folder, { recursive: true });
  const assets = await readdir(join(folder, 'assets'));
  const fresh = randomBytes(3).toString('hex');
  const renamed = assets.map((old) => ({ old, now: old.replace(/-..([\w-]{6}\.\w+)$/, `-${fresh.slice(0, 2)}$1`) }));
  for (const { old, now } of renamed) await rename(join(folder, 'assets', old), join(folder, 'assets', now));
  for (const path of ['index.html', ...renamed.map(({ now }) => `assets/${now}`)].filter((file) =>
    TEXTS.includes(extname(file)),
  )) {
    let text = await readFile(join(folder, path), 'utf8');
    for (const { old, now } of renamed) text = text.replaceAll(old, now);
    if (/^assets\/index-.*\.js$/.test(path))
      text = `document.documentElement.dataset.build = ${JSON.stringify(name)};${text}`;
    await writeFile(join(folder, path), text);
  }
  await change(folder);
  await sealSite(folder);
  return folder;
}

/** @param {string} folder */
export const remove = (folder) => rm(folder, { recursive: true, force: true });
