/** Caches and a host in memory, for the tests of the service worker. */

import { createHash } from 'node:crypto';

export const shaOf = (text: string) => `sha256-${createHash('sha256').update(text).digest('base64')}`;

export function fakeCaches(): CacheStorage & { contents: () => Promise<Record<string, string[]>> } {
  const all: Map<string, Map<string, Response>> = new Map();
  const keyOf = (request: string | { url: string }) => (typeof request === 'string' ? request : request.url);
  const cacheOf = (entries: Map<string, Response>) => ({
    match: async (request: any) => entries.get(keyOf(request))?.clone(),
    put: async (request: any, response: Response) => {
      entries.set(keyOf(request), response);
    },
    delete: async (request: any) => entries.delete(keyOf(request)),
    keys: async () => [...entries.keys()].map((url) => ({ url })),
  });
  return {
    open: async (name: string) => {
      if (!all.has(name)) all.set(name, new Map());
      return cacheOf(all.get(name) as Map<string, Response>);
    },
    keys: async () => [...all.keys()],
    delete: async (name: string) => all.delete(name),
    match: async (request: any) => {
      for (const entries of all.values()) if (entries.has(keyOf(request))) return entries.get(keyOf(request))?.clone();
      return undefined;
    },
    contents: async () => Object.fromEntries([...all].map(([name, entries]) => [name, [...entries.keys()].sort()])),
  } as any;
}

/**
 * A host with some files.
 * @param files by address
 */
export function fakeHost(files: Record<string, string>) {
  const asked: string[] = [];
  return {
    asked,
    fetch: async (request: string | Request, { integrity }: RequestInit = {}) => {
      const url = typeof request === 'string' ? request : request.url;
      asked.push(url);
      const text = files[url];
      if (text === undefined) return new Response('none', { status: 404 });
      if (integrity !== undefined && integrity !== shaOf(text)) throw new TypeError('Failed integrity');
      return new Response(text);
    },
  };
}
