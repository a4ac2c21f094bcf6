/** Workers that hang, and workers that are only slow. */

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { createPool } from './pool.ts';
import { caught, fakeWorkers, job } from './testing.ts';
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

test('a worker that does not say what it is about costs a few seconds, and the job is done by a fresh one', async () => {
  const { fakes, pool } = started();
  const result = pool.run(job('photo', { photo: 'beach.jpg' }));
  vi.advanceTimersByTime(4_000);
  expect(fakes.workers.length).toBe(2);
  expect(fakes.holding('photo')).toBe(fakes.workers[1]);
  fakes.arrive();
  fakes.tell('photo', { expects: 50 });
  fakes.answer('photo');
  expect(await result).toBe('photo');
});

test('so does one that hangs in the middle of short work', async () => {
  const { fakes, pool } = started();
  const result = pool.run(job('panel'));
  fakes.tell('panel', { waits: 30_000 });
  fakes.tell('panel', { expects: 100 });
  vi.advanceTimersByTime(6_000);
  expect(fakes.workers.length).toBe(2);
  fakes.answer('panel');
  expect(await result).toBe('panel');
});

test('a job on which every worker hangs is named after seconds, and the rest go on', async () => {
  const { fakes, pool } = started();
  const result = pool.run(job('photo', { photo: 'beach.jpg' })).catch((error) => error);
  const next = pool.run(job('next'));
  fakes.tell('photo', { expects: 60 });
  vi.advanceTimersByTime(5_000);
  fakes.arrive();
  fakes.tell('photo', { expects: 60 });
  vi.advanceTimersByTime(8_000);
  expect(await result).toMatchObject({ code: 'worker-lost', photo: 'beach.jpg' });
  expect(fakes.workers.length).toBe(3);
  fakes.answer('next');
  expect(await next).toBe('next');
});

test('a large photo on a slow device is waited for', async () => {
  const { fakes, pool } = started();
  const result = pool.run(job('photo'));
  fakes.tell('photo', { waits: 30_000 });
  vi.advanceTimersByTime(25_000);
  // A hundred megapixels.
  fakes.tell('photo', { expects: 6_000 });
  vi.advanceTimersByTime(70_000);
  fakes.tell('photo', { waits: 30_000 });
  vi.advanceTimersByTime(25_000);
  expect(fakes.workers.length).toBe(1);
  fakes.answer('photo');
  expect(await result).toBe('photo');
});

test('what took long once is waited for longer the next time', async () => {
  const { fakes, pool } = started();
  const slow = pool.run(job('first'));
  fakes.tell('first', { expects: 500 });
  vi.advanceTimersByTime(8_000);
  fakes.answer('first');
  await slow;
  pool.run(job('second'));
  fakes.tell('second', { expects: 500 });
  vi.advanceTimersByTime(25_000);
  expect(fakes.workers.length).toBe(1);
});

test('on the second try there is more patience, and at once where there is no second', () => {
  const { fakes, pool } = started();
  void caught(pool.run(job('photo')));
  vi.advanceTimersByTime(3_500);
  expect(fakes.workers.length).toBe(2);
  fakes.arrive();
  vi.advanceTimersByTime(5_500);
  expect(fakes.workers.length).toBe(2);
  vi.advanceTimersByTime(1_000);
  expect(fakes.workers.length).toBe(3);
  fakes.arrive();
  void caught(pool.run(job('frame', { transfer: [new ArrayBuffer(1)] })));
  vi.advanceTimersByTime(5_500);
  expect(fakes.workers.length).toBe(3);
  vi.advanceTimersByTime(1_000);
  expect(fakes.workers.length).toBe(4);
});

test('a script that comes over a slow line has its time, and short work does not wait so long once it is there', () => {
  const fakes = fakeWorkers();
  const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
  void caught(pool.run(job('photo')));
  vi.advanceTimersByTime(29_000);
  expect(fakes.workers.length).toBe(1);
  fakes.arrive();
  vi.advanceTimersByTime(4_000);
  expect(fakes.workers.length).toBe(2);
});

test('what a worker says of a job that is over is not taken for the next', () => {
  const { fakes, pool } = started();
  const stop = new AbortController();
  void caught(pool.run(job('photo', { signal: stop.signal })));
  const { id } = fakes.holding('photo').request;
  fakes.answer('photo');
  void caught(pool.run(job('next')));
  fakes.holding('next').onmessage({ data: { id, waits: 100_000 } });
  vi.advanceTimersByTime(4_000);
  expect(fakes.workers.length).toBe(2);
});
