import { expect, test } from 'vitest';
import { createTimeLeft } from './time-left.ts';

test('the time left follows the speed of the last seconds', () => {
  let at = 0;
  const left = createTimeLeft(() => at);
  const after = (ms: number, done: number) => {
    at = ms;
    return left(done, 100);
  };
  // Too early, or nothing is done.
  expect([after(500, 1), after(2900, 3), after(3100, 0)]).toEqual([null, null, null]);
  // One percent per second.
  expect(after(10_000, 10)).toBe(90);
  // Five percent per second: the slow beginning is forgotten.
  for (let second = 11; second <= 26; second += 1) after(second * 1000, 10 + (second - 10) * 5);
  expect(after(27_000, 95)).toBe(5);
  expect(after(28_000, 100)).toBe(null);
});
