import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { patience } from './patience.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('the limit is kept', () => {
  const over = vi.fn();
  patience(30_000, over);
  vi.advanceTimersByTime(29_999);
  expect(over).not.toHaveBeenCalled();
  vi.advanceTimersByTime(1);
  expect(over).toHaveBeenCalledTimes(1);
});

test('a device that slept for an hour has used up one part', () => {
  const over = vi.fn();
  patience(30_000, over);
  // Overdue timers fire once, independent of the delay.
  vi.setSystemTime(Date.now() + 3_600_000);
  vi.advanceTimersToNextTimer();
  vi.advanceTimersByTime(24_999);
  expect(over).not.toHaveBeenCalled();
  vi.advanceTimersByTime(1);
  expect(over).toHaveBeenCalledTimes(1);
});

test('nothing comes of one that was stopped', () => {
  const over = vi.fn();
  const stop = patience(30_000, over);
  vi.advanceTimersByTime(20_000);
  stop();
  vi.advanceTimersByTime(60_000);
  expect(over).not.toHaveBeenCalled();
});
