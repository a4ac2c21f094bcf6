/**
 * Files that another program shares with the app. The browser posts them. No server receives them, so they wait in a
 * cache until the app opens. The page's half is `app/arrivals.ts`.
 */

/** Target of shared files, as in the manifest. */
export const SHARE = 'share';
export const SHARED = 'inkpanel-shared';
const FOLDER = 'shared/';
/** Lifetime of unclaimed shared files, in milliseconds. */
const LONGEST = 24 * 3600_000;

/** @param world `scope`: the address of the site's folder */
export function createShares({
  scope,
  caches,
  now = Date.now,
}: {
  scope: string;
  caches: CacheStorage;
  now?: () => number;
}) {
  return { take, sweep };

  /** @returns a redirect to the app, which finds the files by the name in the address */
  async function take(request: Request): Promise<Response> {
    const id = `${now()}-${crypto.randomUUID().slice(0, 8)}`;
    const stored = await store(id, request).then(
      () => id,
      () => 'lost',
    );
    return Response.redirect(new URL(`?shared=${stored}`, scope).href, 303);
  }

  async function store(id: string, request: Request) {
    const form = await request.formData();
    const files = [...form.values()].filter((value) => typeof value !== 'string');
    const cache = await caches.open(SHARED);
    await Promise.all(
      files.map((file, i) => {
        const headers = {
          'content-type': file.type || 'application/octet-stream',
          'x-name': encodeURIComponent(file.name),
        };
        return cache.put(new URL(`${FOLDER}${id}/${i}`, scope).href, new Response(file, { headers }));
      }),
    );
  }

  async function sweep() {
    const cache = await caches.open(SHARED);
    for (const { url } of await cache.keys()) {
      const since = url.startsWith(scope) ? Number.parseInt(url.slice(scope.length + FOLDER.length), 10) : now();
      if (now() - since > LONGEST) await cache.delete(url);
    }
  }
}
