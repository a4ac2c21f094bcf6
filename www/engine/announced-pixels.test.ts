import fc from 'fast-check';
import { readFile, readdir } from 'node:fs/promises';
import { expect, test } from 'vitest';
import { announcedPixels } from './announced-pixels.ts';

const PHOTOS = new URL('../../tests/photos/', import.meta.url);
const FILES = new URL('../../tests/oracles/data/files/', import.meta.url);
const bytesOf = async (url: URL) => new Uint8Array(await readFile(url));

/** @param parts bytes, texts, and numbers in little endian */
function bytes(...parts: (number | string | { le: number; size: number })[]) {
  return Uint8Array.from(
    parts.flatMap((part) => {
      if (typeof part === 'number') return [part];
      if (typeof part === 'string') return [...part].map((letter) => letter.charCodeAt(0));
      return Array.from({ length: part.size }, (_, i) => Math.floor(part.le / 256 ** i) % 256);
    }),
  );
}
const le = (value: number, size = 2) => ({ le: value, size });

test.each([
  [
    'a JPEG behind its tables',
    bytes(0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc4, 0, 3, 9, 0xff, 0xff, 0xc2, 0, 17, 8, 0x0b, 0xb8, 0x0f, 0xa0),
    12_000_000,
  ],
  ['a PNG', bytes(0x89, 'PNG\r\n\x1a\n\0\0\0\rIHDR\0\0', 0x13, 0x88, 0, 0, 0x0f, 0xa0), 20_000_000],
  ['a GIF', bytes('GIF89a', le(640), le(480)), 307_200],
  ['a BMP from the top down', bytes('BM', le(0, 12), le(40, 4), le(4000, 4), le(2 ** 32 - 3000, 4)), 12_000_000],
  [
    'a lossy WebP',
    bytes('RIFF', le(0, 4), 'WEBPVP8 ', le(0, 4), 0, 0, 0, 0x9d, 1, 0x2a, le(4000), le(3000)),
    12_000_000,
  ],
  ['a lossless WebP', bytes('RIFF', le(0, 4), 'WEBPVP8L', le(0, 4), 0x2f, le(3999 + 2999 * 2 ** 14, 4)), 12_000_000],
  ['an extended WebP', bytes('RIFF', le(0, 4), 'WEBPVP8X', le(0, 4), le(0, 4), le(3999, 3), le(2999, 3)), 12_000_000],
  [
    'a TIFF',
    bytes('II*\0', le(8, 4), le(2), le(256), le(3), le(1, 4), le(4000, 4), le(257), le(4), le(1, 4), le(3000, 4)),
    12_000_000,
  ],
  [
    'a TIFF the other way round',
    bytes('MM\0*\0\0\0\x08\0\x02\x01\0\0\x03\0\0\0\x01\x0f', 0xa0, '\0\0\x01\x01\0\x04\0\0\0\x01\0\0\x0b', 0xb8),
    12_000_000,
  ],
  ['a bomb, which is refused', bytes(0x89, 'PNG\r\n\x1a\n\0\0\0\rIHDR\0\0', 0xea, 0x60, 0, 0, 0xea, 0x60), 120_000_000],
  ['anything else, by its length', new Uint8Array(1000), 10_000],
  ['nothing', new Uint8Array(0), 0],
])('%s', (_, file, pixels) => {
  expect(announcedPixels(file)).toBe(pixels);
});

test('photos and all formats of the tests say it', async () => {
  const names = (await readdir(PHOTOS)).filter((name) => name.endsWith('.jpg'));
  for (const name of names) {
    const file = await bytesOf(new URL(name, PHOTOS));
    expect(announcedPixels(file), name).toBeGreaterThan(10_000);
    expect(announcedPixels(file), name).not.toBe(Math.min(120_000_000, 10 * file.length));
  }
  for (const name of (await readdir(FILES)).filter((other) => /\.(png|gif|bmp|webp|tiff?)$/.test(other))) {
    const file = await bytesOf(new URL(name, FILES));
    expect(announcedPixels(file), name).not.toBe(10 * file.length);
  }
});

test('whatever bytes there are, it is a number within the limit', () => {
  const heads = fc.constantFrom(
    '\xff\xd8\xff',
    '\x89PNG\r\n',
    'GIF8',
    'BM',
    'RIFF    WEBPVP8X',
    'RIFF    WEBPVP8L',
    'II*\0',
    'MM\0*',
    '',
  );
  fc.assert(
    fc.property(heads, fc.uint8Array({ maxLength: 80 }), (head, rest) => {
      const pixels = announcedPixels(bytes(head, ...rest));
      expect(Number.isInteger(pixels) && pixels >= 0 && pixels <= 120_000_000).toBe(true);
    }),
    { numRuns: 1_000 },
  );
});
