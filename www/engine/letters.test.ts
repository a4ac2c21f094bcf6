import { deflateSync } from 'node:zlib';
import { afterEach, expect, it, vi } from 'vitest';
import { WORDS_MISSING, loadLetters } from './letters.ts';

const TABLE = Uint8Array.from({ length: 4000 }, (_, i) => (i * i) % 251);
const PACKED = new Uint8Array(deflateSync(TABLE));

afterEach(() => vi.unstubAllGlobals());

function host(answer: () => Promise<Response>) {
  vi.stubGlobal('fetch', answer);
}

it('the letters come as they were packed', async () => {
  host(async () => new Response(PACKED));
  expect(await loadLetters(WORDS_MISSING)).toEqual(TABLE);
});

it('letters that do not come, or come broken, are told as missing, and can be tried again', async () => {
  const changed = Uint8Array.from(PACKED);
  changed[changed.length - 1] ^= 1;
  const answers: Record<string, () => Promise<Response>> = {
    'no connection': () => Promise.reject(new TypeError('Failed to fetch')),
    none: async () => new Response('none', { status: 404 }),
    'a page of the host': async () => new Response('<!doctype html>', { headers: { 'content-type': 'text/html' } }),
    'another file': async () => new Response('INKL'),
    'cut short': async () => new Response(PACKED.subarray(0, -40)),
    changed: async () => new Response(changed),
  };
  for (const [what, answer] of Object.entries(answers)) {
    host(answer);
    const error = await loadLetters(['some-missing', 'It is not there.']).catch((error) => error);
    expect([error.code, error.message], what).toEqual(['some-missing', 'It is not there.']);
  }
  host(async () => new Response(PACKED));
  expect(await loadLetters(WORDS_MISSING)).toEqual(TABLE);
});
