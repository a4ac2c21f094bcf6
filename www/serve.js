// @ts-check
/**
 * Serves the built site below a path: `node serve.js PORT PATH [headers]`. As a plain static host does, files only, no
 * header beyond the content type, nothing outside that path; with `headers` also what the site's `_headers` asks for.
 * What is still being built (`nets-module.js`) is answered once it is there.
 */
import { createReadStream, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { TYPES } from './content-types.js';
import { headersOfAll } from './host-headers.js';

const port = Number(process.argv[2] ?? 4187);
const base = process.argv[3] ?? '/';
const root = fileURLToPath(new URL('./dist/', import.meta.url));
const headers = process.argv[4] === 'headers' ? headersOfAll(readFileSync(join(root, '_headers'), 'utf8')) : {};

/** Milliseconds between two looks at a file that is still being built. */
const PATIENCE = 250;

const server = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname);
  const inside = path.startsWith(base) ? normalize(join(root, path.slice(base.length) || 'index.html')) : '';
  const found = inside.startsWith(normalize(root + sep)) && statSync(inside, { throwIfNoEntry: false })?.isFile();
  if (!found || !(await whole(inside, response))) {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('not found');
    return;
  }
  response.writeHead(200, { ...headers, 'content-type': TYPES[extname(inside)] ?? 'application/octet-stream' });
  createReadStream(inside).pipe(response);
});
/**
 * @param {string} file
 * @param {import('node:http').ServerResponse} response
 * @returns {Promise<boolean>} whether it is there, waited for while it has no content yet
 */
async function whole(file, response) {
  if (!/nets-later\.\w+$/.test(file)) return true;
  for (;;) {
    const size = statSync(file, { throwIfNoEntry: false })?.size;
    if (size !== 0) return size !== undefined;
    if (response.destroyed) return false;
    await setTimeout(PATIENCE);
  }
}

server.listen(port, '127.0.0.1', () => process.stdout.write(`http://127.0.0.1:${port}${base}\n`));
