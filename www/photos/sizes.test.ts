import { afterEach, expect, test, vi } from 'vitest';
import { recordOf } from '../engine/metadata/exif.ts';
import { EXIF } from '../engine/metadata/jpeg.ts';
import { segment } from '../engine/metadata/testing.ts';
import { sizeOf, sizesOf } from './sizes.ts';

vi.useFakeTimers();
afterEach(() => vi.clearAllTimers());

const files = ['a', 'b', 'c', 'd'].map((name) => new File([], name));

test('sizes that are known in time are used, and a file that cannot be read is left out', async () => {
  const found = sizesOf(files, async ({ name }) => {
    if (name === 'b') throw new Error('broken');
    if (name === 'c') return null;
    if (name === 'd') await new Promise((done) => setTimeout(done, 60_000));
    return { width: 900, height: 1600 };
  });
  await vi.advanceTimersByTimeAsync(100);
  expect(await found).toEqual(new Map([[files[0], { width: 900, height: 1600 }]]));
});

test('no time passes if all sizes are known', async () => {
  const sizes = await sizesOf(files, async () => ({ width: 3, height: 2 }));
  expect(sizes.size).toBe(4);
  expect(vi.getTimerCount()).toBe(0);
});

/** A JPEG file of 900 by 1600 pixels in this orientation. */
function jpeg(orientation: number): Blob {
  const frame = segment(0xc0, Uint8Array.from([8, 1600 >> 8, 1600 & 255, 900 >> 8, 900 & 255, 3]));
  // A table with a similar marker precedes the frame.
  const table = segment(0xc4, Uint8Array.from([1, 2, 3, 4, 5, 6]));
  return new Blob([Uint8Array.from([0xff, 0xd8]), segment(0xe1, EXIF, recordOf(orientation)), table, frame]);
}

test('sizes of JPEG files are those of the upright photo', async () => {
  expect(await sizeOf(jpeg(1))).toEqual({ width: 900, height: 1600 });
  expect(await sizeOf(jpeg(3))).toEqual({ width: 900, height: 1600 });
  expect(await sizeOf(jpeg(6))).toEqual({ width: 1600, height: 900 });
});

test('other files have no size', async () => {
  for (const text of ['', 'GIF89a and more', 'RIFF....WEBPVP8 '])
    await expect(sizesOf([new File([text], 'a')])).resolves.toEqual(new Map());
  await expect(sizesOf([new File([jpeg(6).slice(0, 40)], 'a')])).resolves.toEqual(new Map());
});

test('the size of a PNG file is in its first chunk', async () => {
  const bytes = new Uint8Array(24);
  const view = new DataView(bytes.buffer);
  for (const [at, value] of [
    [0, 0x89504e47],
    [12, 0x49484452],
    [16, 300],
    [20, 500],
  ])
    view.setUint32(at, value);
  expect(await sizeOf(new Blob([bytes]))).toEqual({ width: 300, height: 500 });
});

test('the size of a WebP file is in its first chunk', async () => {
  const webp = (chunk: string, at: number, ...bytes: number[]) => {
    const head = new Uint8Array(32);
    for (const [place, text] of [
      [0, 'RIFF'],
      [8, 'WEBP'],
      [12, chunk],
    ] as const)
      head.set(
        [...text].map((letter) => letter.charCodeAt(0)),
        place,
      );
    head.set(bytes, at);
    return sizeOf(new Blob([head]));
  };
  const size = { width: 900, height: 1600 };
  expect(await webp('VP8 ', 26, 132, 3, 64, 6)).toEqual(size);
  expect(await webp('VP8X', 24, 131, 3, 0, 63, 6, 0)).toEqual(size);
  // 14 bits each: 899 and 1599.
  expect(await webp('VP8L', 21, ...new Uint8Array(Uint32Array.of(899 | (1599 << 14)).buffer))).toEqual(size);
  expect(await webp('ANIM', 24, 1)).toBe(null);
});
