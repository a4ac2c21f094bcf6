// @ts-check
/** Reads the engine's own files from the disk, as Node's `fetch` knows no addresses of files. */

import { readFile } from 'node:fs/promises';
import { readAssetsWith } from './assets.js';

export function readFromDisk() {
  readAssetsWith(async (address) => {
    const url = new URL(address);
    if (url.protocol !== 'file:') return fetch(url);
    try {
      return new Response(await readFile(url));
    } catch {
      return new Response(null, { status: 404 });
    }
  });
}
