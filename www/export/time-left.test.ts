import { expect, test } from 'vitest';
import { createTimeLeft } from './time-left.ts';

test('the time left follows the speed of the last seconds', () => {
  let at = 0;
  const left = createTimeLeft(() => at);
  const after = (ms: number, done: number) => {
    at = ms;
    return left(done, 100);
  };
  // Nothing is done, or too little since the first step, which is slow.
  expect([after(4000, 0), after(10_000, 2), after(12_000, 6), after(14_000, 4)]).toEqual([null, null, null, null]);
  // One percent per second since the first step.
  expect(after(20_000, 12)).toBe(90);
  // Five percent per second: the slow beginning is forgotten.
  for (let second = 21; second <= 36; second += 1) after(second * 1000, 12 + (second - 20) * 5);
  expect(after(37_000, 95)).toBe(5);
  expect(after(38_000, 100)).toBe(null);
});
