import { expect, test } from 'vitest';
import { overlapped } from './overlap.ts';

test('two items are in work, and the results have the order of the items', async () => {
  const ends: ((value: string) => void)[] = [];
  const started: number[] = [];
  const done = overlapped(['a', 'b', 'c'], (item, i) => {
    started.push(i);
    return new Promise<string>((resolve) => ends.push(() => resolve(item.toUpperCase())));
  });
  expect(started).toEqual([0, 1]);
  ends[1]('');
  await expect.poll(() => started).toEqual([0, 1, 2]);
  ends[2]('');
  ends[0]('');
  expect(await done).toEqual(['A', 'B', 'C']);
});

test('after a failure no other item starts', async () => {
  const started: number[] = [];
  const work = async (item: number) => {
    started.push(item);
    if (item === 1) throw new Error('no');
    return new Promise<number>(() => {});
  };
  await expect(overlapped([0, 1, 2, 3], work)).rejects.toThrow('no');
  expect(started).toEqual([0, 1]);
});
