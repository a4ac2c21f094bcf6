// @ts-check
/** Reads the engine's files from disk, because Node's `fetch` does not support file URLs. */

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
