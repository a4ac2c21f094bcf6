/**
 * The cached builds of the site. Each has a separate cache that is filled atomically. An open page continues with the
 * files of its build when a newer one takes over. Its cache stays until the last such page is closed. Files of
 * different builds cannot meet, as scripts name other files by their content.
 *
 * Not by Workbox: it keeps one cache for all builds, and would bring Babel and a second Rollup into the build.
 */

import type { Site, SiteFile } from './worker-types.ts';

/** Prefix of the locks that open tabs hold; the address of their script follows. */
export const PAGE_LOCK = 'inkpanel.page ';
/** Cache of the engine for files in `onUse`. */
export const NETS = 'inkpanel-nets';
/** Files loaded side by side: the page may be loading too. */
const AT_ONCE = 4;
/** Folder of the files with content hashes in their names. */
const HASHED = 'assets/';

/**
 * @param world `scope`: the address of the site's folder; `windows`: number of open pages; `updating`: whether another
 * build is being installed or waits
 */
export function createVersions({
  site,
  scope,
  caches,
  fetch,
  locks,
  windows,
  updating,
}: {
  site: Site;
  scope: string;
  caches: CacheStorage;
  fetch: typeof globalThis.fetch;
  locks: Pick<LockManager, 'query'> | undefined;
  windows: () => Promise<number>;
  updating: () => boolean;
}) {
  /** Sites in other folders of the same host have theirs. */
  const prefix = `inkpanel ${new URL(scope).pathname} `;
  const name = prefix + site.version;
  const known = new Set([...site.needed, ...site.extras].map(([path]) => path));

  return { install, keepExtras, pathOf, has, answer, sweep };

  /** Rejects if any file is missing or belongs to another build, and then removes the others. */
  async function install() {
    const cache = await caches.open(name);
    const rest = [...site.needed];
    const work = async () => {
      for (let file = rest.shift(); file; file = rest.shift()) await keep(cache, file);
    };
    try {
      await Promise.all(Array.from({ length: AT_ONCE }, work));
    } catch (error) {
      rest.length = 0;
      await caches.delete(name);
      throw error;
    }
  }

  /** Caches missing optional files. */
  async function keepExtras() {
    const cache = await caches.open(name);
    for (const file of site.extras) await keep(cache, file);
  }

  async function keep(cache: Cache, [path, integrity]: SiteFile) {
    const url = new URL(path, scope).href;
    if (await cache.match(url)) return;
    const before = await caches.match(url);
    const same = before && (await integrityOf(before.clone())) === integrity ? before : undefined;
    await cache.put(url, same ?? (await load(path, integrity)));
  }

  async function load(path: string, integrity: string) {
    // A host in the middle of an update, or a cache before it, may have a file of another build.
    const how: RequestInit = { integrity, cache: path.startsWith(HASHED) ? 'default' : 'no-cache', priority: 'low' };
    const response = await fetch(new URL(path, scope).href, how);
    if (response.ok) return plain(response);
    // Some hosts do not show a folder's page under the folder's name.
    const named = path === '' ? await fetch(new URL('index.html', scope).href, how) : response;
    if (!named.ok) throw new Error(`${path}: ${named.status}`);
    return plain(named);
  }

  /** Browsers refuse a redirected answer for a page. */
  function plain(response: Response) {
    if (!response.redirected) return response;
    const { status, statusText, headers } = response;
    return new Response(response.body, { status, statusText, headers });
  }

  /** @returns the path of a file of the site, `''` for the page; null for everything else */
  function pathOf({ url, mode }: Request): string | null {
    const address = new URL(url);
    const at = address.origin + address.pathname;
    if (!at.startsWith(scope)) return null;
    const path = at.slice(scope.length);
    return mode === 'navigate' && path === 'index.html' ? '' : path;
  }

  /** Whether `answer` handles a file. Files in `onUse` are cached by their users. */
  function has(path: string) {
    return known.has(path) || (path.startsWith(HASHED) && !site.onUse.includes(path));
  }

  /** @returns from this build, or from another cached build, or from the server */
  async function answer(path: string, request: Request): Promise<Response> {
    const url = new URL(path, scope).href;
    const kept = await find(path, url).catch(() => undefined);
    return kept ?? fetch(request);
  }

  async function find(path: string, url: string) {
    const own = known.has(path) ? await (await caches.open(name)).match(url) : undefined;
    return own ?? (path.startsWith(HASHED) ? caches.match(url) : undefined);
  }

  /** Throws away the builds that no open page is of. */
  async function sweep() {
    const used = await openPages();
    if (!used) return;
    let alone = true;
    for (const other of await caches.keys()) {
      if (!other.startsWith(prefix) || other === name) continue;
      const cache = await caches.open(other);
      const found = await Promise.all(used.map((url) => cache.match(url)));
      if (updating()) return;
      if (found.some(Boolean)) alone = false;
      else await caches.delete(other);
    }
    if (alone) await sweepNets();
  }

  /** @returns scripts of the open tabs; null if they are unknown */
  async function openPages(): Promise<string[] | null> {
    if (!locks) return (await windows()) > 1 ? null : [];
    const { held = [] } = await locks.query();
    return held.flatMap((lock) => (lock.name?.startsWith(PAGE_LOCK) ? [lock.name.slice(PAGE_LOCK.length)] : []));
  }

  async function sweepNets() {
    const nets = await caches.open(NETS);
    const mine = new Set(site.onUse.map((path) => new URL(path, scope).href));
    for (const { url } of await nets.keys()) {
      if (url.startsWith(scope) && !mine.has(url)) await nets.delete(url);
    }
  }
}

/** @returns a hash in the format of `integrity` */
export async function integrityOf(response: Response): Promise<string> {
  const digest = await crypto.subtle.digest('SHA-256', await response.arrayBuffer());
  return `sha256-${btoa(String.fromCharCode(...new Uint8Array(digest)))}`;
}
