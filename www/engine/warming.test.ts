import { expect, test, vi } from 'vitest';
import { createWarming } from './warming.ts';
import type { PageDocument } from './types.ts';

const pages = [1, 2].map((seed) => ({ seed }) as PageDocument);

test('one made-up photo after the other is read and drawn, on one page after the other', async () => {
  const run = vi.fn(async () => null) as any;
  await createWarming(run).warm(pages);
  const asked = run.mock.calls.map(([{ op, args }]: any) => [op, JSON.parse(args.document).seed]);
  expect(asked.slice(0, 3)).toEqual([
    ['warm', 1],
    ['warm', 2],
    ['warm', 1],
  ]);
});

test('workers that have code of their own are warmed side by side', async () => {
  let [running, most] = [0, 0];
  const run = vi.fn(async () => {
    most = Math.max(most, (running += 1));
    await Promise.resolve();
    running -= 1;
    return null;
  }) as any;
  await createWarming(run, 2).warm(pages);
  expect(most).toBe(2);
});

test('it ends with the first real work, and where it fails', async () => {
  const run = vi.fn(async () => null) as any;
  const warming = createWarming(run);
  const done = warming.warm(pages);
  warming.stop();
  await done;
  expect(run).toHaveBeenCalledTimes(1);
  expect(run.mock.calls[0][0].signal.aborted).toBe(true);
  await warming.warm(pages);
  expect(run).toHaveBeenCalledTimes(1);

  const failing = vi.fn(async () => Promise.reject(new Error('no canvas'))) as any;
  await createWarming(failing).warm(pages);
  expect(failing).toHaveBeenCalledTimes(1);
});
