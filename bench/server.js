// @ts-check
/** A file server on a free port for the benchmark's pages. */

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { TYPES } from '../www/content-types.js';

/** Enables SharedArrayBuffer, which wasm-vips needs, and a finer clock. */
const ISOLATED = { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' };

/**
 * @param {Record<string, string>} folders first part of the path -> folder on disk
 * @param {{ isolated: boolean }} options
 * @returns {Promise<{ address: string, close: () => void }>}
 */
export async function serve(folders, { isolated }) {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname);
    const [, first, ...rest] = path.split('/');
    const folder = folders[first];
    const file = folder && normalize(join(folder, rest.join('/') || 'index.html'));
    if (!file?.startsWith(normalize(folder)) || !statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404, { 'content-type': 'text/plain' }).end('not found');
      return;
    }
    const type = TYPES[extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { 'content-type': type, ...(isolated ? ISOLATED : {}) });
    createReadStream(file).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const address = /** @type {import('node:net').AddressInfo} */ (server.address());
  return { address: `http://127.0.0.1:${address.port}`, close: () => server.close() };
}
