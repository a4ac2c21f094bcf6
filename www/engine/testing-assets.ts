/** Lets tests load the wasm modules of the page from their files. */

import { readFileSync } from 'node:fs';
import { readAssetsWith } from './assets.ts';

export function readAssetsFromFiles() {
  readAssetsWith(async (address) => new Response(readFileSync(new URL(address))));
}
