import { afterEach, expect, test, vi } from 'vitest';
import { sizesOf } from './sizes.ts';

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
