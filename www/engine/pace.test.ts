import { expect, test } from 'vitest';
import { createPace } from './pace.ts';

test('short work is given seconds, long work more', () => {
  const { patience } = createPace();
  expect(patience(0)).toBe(3_000);
  expect(patience(50)).toBeLessThan(5_000);
  expect(patience(6_000)).toBeGreaterThan(60_000);
});

test('on a device that proved to be slow all is given more, at once; on a quick one less, by and by', () => {
  const pace = createPace();
  const first = pace.patience(1_000);
  pace.took(1_000, 12_000);
  expect(pace.patience(1_000)).toBeGreaterThan(2 * first);
  pace.took(1_000, 500);
  expect(pace.patience(1_000)).toBeGreaterThan(2 * first);
  for (let i = 0; i < 40; i += 1) pace.took(1_000, 500);
  expect(pace.patience(1_000)).toBeLessThan(7_500);
});

test('neither a device that slept nor work of no length changes it out of measure', () => {
  const pace = createPace();
  pace.took(10, 5_000);
  expect(pace.patience(1_000)).toBe(createPace().patience(1_000));
  pace.took(1_000, 3_600_000);
  expect(pace.patience(1_000)).toBeLessThan(100_000);
});
