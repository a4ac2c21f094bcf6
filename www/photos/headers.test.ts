import { afterEach, expect, test, vi } from 'vitest';
import { headersOf, sizesIn } from './headers.ts';

vi.useFakeTimers();
afterEach(() => vi.clearAllTimers());

const files = ['a', 'b', 'c'].map((name) => new File([], name));
const header = { size: { width: 900, height: 1600 }, thumbnail: null, turn: 0 };

test('sizes that are known in time are used, and files without a header are left out', async () => {
  const headers = headersOf(files, async ({ name }) => {
    if (name === 'b') return null;
    if (name === 'c') await new Promise((done) => setTimeout(done, 60_000));
    return header;
  });
  const found = sizesIn(headers);
  await vi.advanceTimersByTimeAsync(100);
  expect(await found).toEqual(new Map([[files[0], header.size]]));
});

test('no time passes if all sizes are known', async () => {
  const sizes = await sizesIn(headersOf(files, async () => header));
  expect(sizes.size).toBe(3);
  expect(vi.getTimerCount()).toBe(0);
});

test('only the headers of the first files are read', () => {
  const many = Array.from({ length: 300 }, (_, i) => new File([], `${i}.jpg`));
  expect([...headersOf(many, async () => null).keys()]).toEqual(many.slice(0, 40));
});
