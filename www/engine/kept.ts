/**
 * Large optional files. The browser stores them after their first use, so that they are available offline. Here and not
 * in a service worker, which a first visit does not have yet.
 */

import { fetchAsset } from './assets.ts';
import { after } from './scheduler.ts';
import type { AssetReader } from './assets.ts';

/** The service worker throws away what no build of the site names any more (`offline/worker/versions.ts`). */
const STORE = 'inkpanel-nets';
/** Milliseconds until a loaded file is cached, so that caching does not delay its use. */
const LATER = 5_000;
/** Milliseconds after its first result in which a worker may still store a file. */
export const STORED_AFTER = LATER + 3_000;
/** A file name with a content hash from the build. Any other name may belong to an older file. */
const HASHED = /-[\w-]{8}\.\w+$/;

/** As `fetch`. */
export async function fetchKept(
  address: string,
  {
    caches = globalThis.caches,
    fetch = fetchAsset,
    later = LATER,
  }: { caches?: CacheStorage; fetch?: AssetReader; later?: number } = {},
): Promise<Response> {
  // Refused without https, and in some private windows.
  const store = HASHED.test(address) ? await caches?.open(STORE).catch(() => undefined) : undefined;
  const kept = await store?.match(address).catch(() => undefined);
  if (kept) return kept;
  const response = await fetch(address);
  if (store && response.ok && !isPage(response)) {
    const copy = response.clone();
    // If storage is full, the file is downloaded again next time.
    after(later, () => void keep(store, address, copy).catch(() => {}));
  }
  return response;
}

/** Two workers may have loaded the same file. */
async function keep(store: Cache, address: string, response: Response) {
  if (await store.match(address)) await response.body?.cancel();
  else await store.put(address, response);
}

/** Detects an HTML page, which some servers return instead of a missing file. */
export function isPage(response: Response) {
  return response.headers.get('content-type')?.startsWith('text/html') ?? false;
}
