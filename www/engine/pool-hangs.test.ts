/** Workers that hang. */

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { createPool } from './pool.ts';
import { caught, fakeWorkers, job } from './testing.ts';
import { limitOf } from './time-limits.ts';
import type { Named } from './testing.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A pool of one worker that is there. */
function started() {
  const fakes = fakeWorkers();
  const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
  fakes.arrive();
  return { fakes, pool };
}

test('a worker that hangs costs the limit of its operation, and the job is done by a fresh one', async () => {
  const { fakes, pool } = started();
  const result = pool.run(job('photo', { photo: 'beach.jpg' }));
  vi.advanceTimersByTime(19_000);
  expect(fakes.workers.length).toBe(1);
  vi.advanceTimersByTime(2_000);
  expect(fakes.workers.length).toBe(2);
  expect(fakes.holding('photo')).toBe(fakes.workers[1]);
  fakes.arrive();
  fakes.answer('photo');
  expect(await result).toBe('photo');
});

test('a job on which every worker hangs is named, and the others go on', async () => {
  const { fakes, pool } = started();
  const result = pool.run(job('photo', { photo: 'beach.jpg' })).catch((error) => error);
  const next = pool.run(job('next'));
  vi.advanceTimersByTime(20_000);
  fakes.arrive();
  vi.advanceTimersByTime(39_000);
  expect(fakes.workers.length).toBe(2);
  vi.advanceTimersByTime(2_000);
  expect(await result).toMatchObject({ code: 'worker-lost', photo: 'beach.jpg' });
  expect(fakes.workers.length).toBe(3);
  fakes.answer('next');
  expect(await next).toBe('next');
});

test('a job that downloads a file or paints has five minutes', async () => {
  const { fakes, pool } = started();
  void caught(pool.run(job('photo')));
  fakes.tell('photo', { slow: true });
  vi.advanceTimersByTime(299_000);
  expect(fakes.workers.length).toBe(1);
  vi.advanceTimersByTime(2_000);
  expect(fakes.workers.length).toBe(2);
});

test('every operation has a limit, and files have more time than panels', () => {
  expect([limitOf('panel'), limitOf('import'), limitOf('pdf')]).toEqual([20_000, 30_000, 300_000]);
});

test('a job that cannot be repeated has twice the time at once', () => {
  const { fakes, pool } = started();
  void caught(pool.run(job('frame', { transfer: [new ArrayBuffer(1)] })));
  vi.advanceTimersByTime(39_000);
  expect(fakes.workers.length).toBe(1);
  vi.advanceTimersByTime(2_000);
  expect(fakes.workers.length).toBe(2);
});

test('a script that arrives over a slow connection has its time before the job has its own', () => {
  const fakes = fakeWorkers();
  const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
  void caught(pool.run(job('photo')));
  vi.advanceTimersByTime(29_000);
  fakes.arrive();
  vi.advanceTimersByTime(19_000);
  expect(fakes.workers.length).toBe(1);
  vi.advanceTimersByTime(2_000);
  expect(fakes.workers.length).toBe(2);
});

test('a late message about the previous job does not extend the limit of the next one', () => {
  const { fakes, pool } = started();
  const stop = new AbortController();
  void caught(pool.run(job('photo', { signal: stop.signal })));
  const { id } = fakes.holding('photo').request;
  fakes.answer('photo');
  void caught(pool.run(job('next')));
  fakes.holding('next').onmessage({ data: { id, slow: true } });
  vi.advanceTimersByTime(21_000);
  expect(fakes.workers.length).toBe(2);
});
