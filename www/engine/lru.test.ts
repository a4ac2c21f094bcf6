import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createLru } from './lru.ts';

test('the least recently used goes first, what is needed stays', () => {
  const lru = createLru(10);
  for (const key of ['a', 'b', 'c']) lru.touch(key, 4);
  lru.touch('a', 4);
  expect(lru.evict()).toEqual(['b']);
  lru.touch('d', 6);
  expect(lru.evict((key) => key === 'c')).toEqual(['a']);
  expect(lru.total).toBe(10);
});

test('after eviction the total fits, and is the sum of what is left', () => {
  const uses = fc.array(fc.tuple(fc.constantFrom(...'abcdefgh'), fc.integer({ min: 0, max: 50 })), { maxLength: 60 });
  fc.assert(
    fc.property(uses, fc.integer({ min: 0, max: 100 }), (list, budget) => {
      const lru = createLru(budget);
      const sizes = new Map();
      for (const [key, bytes] of list) {
        lru.touch(key, bytes);
        sizes.set(key, bytes);
        for (const gone of lru.evict()) sizes.delete(gone);
        expect(lru.total).toBe([...sizes.values()].reduce((sum, size) => sum + size, 0));
        expect(lru.total).toBeLessThanOrEqual(budget);
      }
    }),
  );
});
