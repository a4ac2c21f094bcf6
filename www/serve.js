// @ts-check
/**
 * Serves the built site below a path, like a static host: `node serve.js PORT PATH [headers]`, port 0 for any. It
 * serves only compressed files below this path, and sends only headers about the content. With `headers`, it also sends
 * the headers of the site's `_headers`.
 * A request for a file that is still being built (`nets-module.js`) waits for it.
 */
import { createReadStream, readFileSync, statSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { gzip } from 'node:zlib';
import { TYPES } from './content-types.js';
import { headersOfAll } from './host-headers.js';

const port = Number(process.argv[2] ?? 4187);
const base = process.argv[3] ?? '/';
const root = fileURLToPath(new URL('./dist/', import.meta.url));
const headers = process.argv[4] === 'headers' ? headersOfAll(readFileSync(join(root, '_headers'), 'utf8')) : {};

/** Extensions that hosts compress. Pictures and fonts are already compressed. */
const SHRINKS = new Set(['.html', '.js', '.css', '.json', '.wasm', '.svg', '.webmanifest']);
/** Files compressed, by path and time of change. @type {Map<string, Promise<Buffer>>} */
const small = new Map();

/** Milliseconds between two checks for a file that is still being built. */
const PATIENCE = 250;

const server = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname);
  const inside = path.startsWith(base) ? normalize(join(root, path.slice(base.length) || 'index.html')) : '';
  const found = inside.startsWith(normalize(root + sep)) && statSync(inside, { throwIfNoEntry: false })?.isFile();
  if (!found || !(await whole(inside, response))) {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('not found');
    return;
  }
  const type = extname(inside);
  const content = { ...headers, 'content-type': TYPES[type] ?? 'application/octet-stream' };
  if (!SHRINKS.has(type) || !/\bgzip\b/.test(String(request.headers['accept-encoding']))) {
    response.writeHead(200, content);
    createReadStream(inside).pipe(response);
    return;
  }
  const bytes = await compressed(inside);
  response.writeHead(200, { ...content, 'content-encoding': 'gzip', vary: 'accept-encoding' }).end(bytes);
});

/**
 * @param {string} file
 * @returns {Promise<Buffer>} the compressed file, cached until it changes
 */
function compressed(file) {
  const key = `${file} ${statSync(file).mtimeMs}`;
  const known = small.get(key);
  if (known) return known;
  const made = readFile(file).then((bytes) => promisify(gzip)(bytes));
  small.set(key, made);
  return made;
}

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

server.listen(port, '127.0.0.1', () => {
  const { port: given } = /** @type {import('node:net').AddressInfo} */ (server.address());
  process.stdout.write(`http://127.0.0.1:${given}${base}\n`);
});
