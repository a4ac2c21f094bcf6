import { expect, test, vi } from 'vitest';
import { blobOf, detach } from './blobs.ts';

const bytes = () => Uint8Array.from([1, 2, 3]);

/** @param bad number of unreadable blobs at the start */
function browser(bad: number) {
  return vi.fn((parts: BlobPart[], options: BlobPropertyBag) => {
    const blob = new Blob(parts, options);
    const refused = () => ({
      arrayBuffer: async () => {
        throw new DOMException('', 'NotReadableError');
      },
    });
    return ((bad -= 1) >= 0 ? { slice: refused } : blob) as any;
  });
}

test('a blob is made until it can be read', async () => {
  const make = browser(3);
  const given = bytes();
  const blob = await blobOf(given, { type: 'image/png', wait: 0, make });
  expect(make).toHaveBeenCalledTimes(4);
  expect([blob.type, [...new Uint8Array(await blob.arrayBuffer())]]).toEqual(['image/png', [1, 2, 3]]);
  expect(given.length, 'is given back').toBe(0);
});

test('where there never is room it is an error with a code', async () => {
  const [make, given] = [browser(Infinity), bytes()];
  await expect(blobOf(given, { wait: 0, make })).rejects.toMatchObject({ code: 'no-room' });
  expect(make.mock.calls.length).toBeLessThan(10);
  expect(given.length, 'is still there').toBe(3);
});

test('bytes are given back at any time, and once', async () => {
  for (let i = 0; i < 3; i += 1) {
    const given = bytes();
    detach(given);
    expect(given.length).toBe(0);
    expect(() => detach(given)).not.toThrow();
    await new Promise((resolve) => {
      setTimeout(resolve, 20);
    });
  }
});
