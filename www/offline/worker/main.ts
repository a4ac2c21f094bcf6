/**
 * The service worker: the site without a connection, and files shared with it. It is built with the list of the site's
 * files in it, so that each build has another. A new version waits until all tabs with the old version are closed, or
 * the user accepts it.
 */

import { SHARE, createShares } from './shares.ts';
import { createVersions } from './versions.ts';
import type { OrderEvent, RequestEvent, Site, WorkEvent, WorkerScope } from './worker-types.ts';

const worker = globalThis as unknown as WorkerScope;
const { scope } = worker.registration;

/** A constant of the build. */
declare const INKPANEL_SITE: Site;

const versions = createVersions({
  site: INKPANEL_SITE,
  scope,
  caches,
  fetch: fetch.bind(globalThis),
  locks: navigator.locks,
  windows: async () => (await worker.clients.matchAll({ type: 'window', includeUncontrolled: true })).length,
  updating: () => !!(worker.registration.installing ?? worker.registration.waiting),
});
const shares = createShares({ scope, caches });

worker.addEventListener('install', (event: WorkEvent) => event.waitUntil(versions.install()));

// The first page is not controlled until it is claimed; an old one would not be loaded again for it.
worker.addEventListener('activate', (event: WorkEvent) =>
  event.waitUntil(Promise.all([worker.clients.claim(), versions.sweep()])),
);

worker.addEventListener('message', (event: OrderEvent) => {
  if (event.data?.op === 'take-over') event.waitUntil(worker.skipWaiting());
  if (event.data?.op === 'settle') event.waitUntil(settle(event.data.extras ?? false));
});

worker.addEventListener('fetch', (event: RequestEvent) => {
  const { request } = event;
  // On a host without headers, a service worker has no Content-Security-Policy.
  if (new URL(request.url).origin !== new URL(scope).origin) return event.respondWith(Response.error());
  const path = versions.pathOf(request);
  if (request.method === 'POST' && path === SHARE) return event.respondWith(shares.take(request));
  if (request.method === 'GET' && path !== null && versions.has(path))
    return event.respondWith(versions.answer(path, request));
});

/** Low-priority work after a page has loaded. */
async function settle(extras: boolean) {
  await Promise.all([versions.sweep(), shares.sweep()]);
  if (extras) await versions.keepExtras();
}
