// @ts-check
/** Caches and a host in memory, for the tests of the service worker. */

import { createHash } from 'node:crypto';

/** @param {string} text */
export const shaOf = (text) => `sha256-${createHash('sha256').update(text).digest('base64')}`;

/** @returns {CacheStorage & { contents: () => Promise<Record<string, string[]>> }} */
export function fakeCaches() {
  /** @type {Map<string, Map<string, Response>>} */
  const all = new Map();
  const keyOf = (/** @type {string | { url: string }} */ request) => (typeof request === 'string' ? request : request.url);
  const cacheOf = (/** @type {Map<string, Response>} */ entries) => ({
    match: async (/** @type {any} */ request) => entries.get(keyOf(request))?.clone(),
    put: async (/** @type {any} */ request, /** @type {Response} */ response) => { entries.set(keyOf(request), response); },
    delete: async (/** @type {any} */ request) => entries.delete(keyOf(request)),
    keys: async () => [...entries.keys()].map((url) => ({ url })),
  });
  return /** @type {any} */ ({
    open: async (/** @type {string} */ name) => {
      if (!all.has(name)) all.set(name, new Map());
      return cacheOf(/** @type {Map<string, Response>} */ (all.get(name)));
    },
    keys: async () => [...all.keys()],
    delete: async (/** @type {string} */ name) => all.delete(name),
    match: async (/** @type {any} */ request) => {
      for (const entries of all.values()) if (entries.has(keyOf(request))) return entries.get(keyOf(request))?.clone();
      return undefined;
    },
    contents: async () => Object.fromEntries([...all].map(([name, entries]) => [name, [...entries.keys()].sort()])),
  });
}

/**
 * A host with some files.
 * @param {Record<string, string>} files by address
 */
export function fakeHost(files) {
  /** @type {string[]} */
  const asked = [];
  return {
    asked,
    /** @param {string | Request} request @param {RequestInit} [how] */
    fetch: async (request, { integrity } = {}) => {
      const url = typeof request === 'string' ? request : request.url;
      asked.push(url);
      const text = files[url];
      if (text === undefined) return new Response('none', { status: 404 });
      if (integrity !== undefined && integrity !== shaOf(text)) throw new TypeError('Failed integrity');
      return new Response(text);
    },
  };
}
