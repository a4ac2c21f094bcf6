import { expect, test } from 'vitest';
import { createPool } from './pool.ts';
import { Priority } from './queue.ts';
import { fakeWorkers, job } from './testing.ts';
import type { Named } from './testing.ts';

test('a crowd that nobody waits for leaves a worker to the page', () => {
  const fakes = fakeWorkers();
  const pool = createPool<Named>({ size: 2, spawn: fakes.spawn });
  const names = Array.from({ length: 34 }, (_, i) => `rest ${i}`);
  for (const name of ['a', 'b']) pool.run(job(name, { priority: Priority.REST }));
  for (const name of names) pool.run(job(name, { priority: Priority.REST }));
  const running = () => ['a', 'b', ...names, 'panel'].filter((name) => fakes.holding(name));
  fakes.answer('a');
  expect(running()).toEqual(['b']);
  pool.run(job('panel', { priority: Priority.PANEL }));
  expect(running()).toEqual(['b', 'panel']);
  fakes.answer('panel');
  fakes.answer('b');
  for (let done = 0; done < 8; done += 1) fakes.answer(`rest ${done}`);
  expect(running()).toEqual(['rest 8']);
  // Near the end both continue.
  fakes.answer('rest 8');
  expect(running()).toEqual(['rest 9', 'rest 10']);
});
