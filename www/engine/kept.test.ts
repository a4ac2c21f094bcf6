import { expect, it, vi } from 'vitest';
import { fakeCaches } from '../offline/worker/testing.ts';
import { fetchKept } from './kept.ts';

const NET = 'https://host.test/assets/faces-Ab3_-x9Q.onnx';
const net = async () => new Response('net');
const page = async () => new Response('<p>', { headers: { 'content-type': 'text/html' } });

it('a net is loaded once', async () => {
  const caches = fakeCaches();
  const fetch = vi.fn(net);
  expect(await (await fetchKept(NET, { caches, fetch, later: 0 })).text()).toBe('net');
  await vi.waitFor(async () => expect(await caches.match(NET)).toBeDefined());
  expect(await (await fetchKept(NET, { caches, fetch })).text()).toBe('net');
  expect(fetch).toHaveBeenCalledTimes(1);
});

it('it is kept when whoever loaded it has had time to use it, and once where two have loaded it', async () => {
  vi.useFakeTimers();
  const caches = fakeCaches();
  const store = await caches.open('inkpanel-nets');
  const put = vi.spyOn(store, 'put');
  const one = { open: async () => store } as any;
  await Promise.all([fetchKept(NET, { caches: one, fetch: net }), fetchKept(NET, { caches: one, fetch: net })]);
  await vi.advanceTimersByTimeAsync(1000);
  expect(put).not.toHaveBeenCalled();
  await vi.advanceTimersByTimeAsync(10_000);
  expect(put).toHaveBeenCalledTimes(1);
  vi.useRealTimers();
});

it.each([
  ['has no name of its content', NET.replace('-Ab3_-x9Q', ''), net],
  ['is missing', NET, async () => new Response('', { status: 404 })],
  ['is the page of the host', NET, page],
])('what %s is not kept', async (_, address, fetch) => {
  const caches = fakeCaches();
  await fetchKept(address, { caches, fetch, later: 0 });
  await new Promise((resolve) => {
    setTimeout(resolve, 20);
  });
  expect(await caches.match(address)).toBeUndefined();
});

it('where the browser keeps nothing it is loaded each time', async () => {
  const fetch = vi.fn(net);
  const refused = {
    open: async () => {
      throw new Error('SecurityError');
    },
  } as any;
  expect(await (await fetchKept(NET, { caches: refused, fetch })).text()).toBe('net');
  expect(await (await fetchKept(NET, { caches: undefined, fetch })).text()).toBe('net');
  expect(fetch).toHaveBeenCalledTimes(2);
});
