import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createQueue } from './queue.ts';

const entries = fc.array(
  fc.record({
    priority: fc.integer({ min: 0, max: 3 }),
    key: fc.option(fc.constantFrom('a', 'b', 'c'), { nil: undefined }),
  }),
);

test('entries leave by priority, then in the order they came, one a key', () => {
  fc.assert(
    fc.property(entries, (list) => {
      const queue: ReturnType<typeof createQueue<{ priority: number; key?: string; n: number }>> = createQueue();
      const numbered = list.map((entry, n) => ({ ...entry, n }));
      const dropped = new Set(numbered.flatMap((entry) => queue.push(entry)?.n ?? []));
      const expected = numbered.filter(({ n }) => !dropped.has(n)).sort((a, b) => a.priority - b.priority || a.n - b.n);
      const taken = [];
      for (let entry = queue.take(); entry; entry = queue.take()) taken.push(entry);
      expect(taken).toEqual(expected);
      const keys = taken.flatMap(({ key }) => key ?? []);
      expect(new Set(keys).size).toBe(keys.length);
      const newest = new Map(numbered.map(({ key, n }) => [key, n] as [string | undefined, number]));
      for (const { key, n } of taken) if (key !== undefined) expect(n).toBe(newest.get(key));
    }),
  );
});
