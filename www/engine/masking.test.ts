import { afterEach, beforeEach, expect, test, vi } from 'vitest';

vi.mock('./subject-net.ts', () => ({ NET: '/subject.onnx' }));
const { createScheduler } = await import('./scheduler.ts');
const { createMasking } = await import('./masking.ts');

/** Slices of work of a mask. */
const PARTS = 3;

type Order = { id: number; args: { look: number } };

/** Workers that need some parts for a look, and each forget it when they end. */
function workers() {
  const looks: number[] = [];
  const all: Parting[] = [];
  class Parting {
    ended = false;
    parts = new Map<number, number>();
    onmessage: ((event: { data: unknown }) => void) | undefined;
    constructor() {
      all.push(this);
    }
    postMessage({ id, args: { look } }: Order) {
      looks.push(look);
      const parts = (this.parts.get(look) ?? 0) + 1;
      this.parts.set(look, parts);
      queueMicrotask(() => this.onmessage?.({ data: { id, ok: parts === PARTS ? `mask ${look}` : null, memory: 0 } }));
    }
    terminate() {
      this.ended = true;
    }
  }
  vi.stubGlobal('Worker', Parting);
  return { looks, all };
}

const photos = { get: (id: string) => ({ name: `${id}.jpg`, small: { width: 600, height: 400 }, work: {} }) } as any;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('document', { baseURI: 'https://example.org/' });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test('a look is asked for in parts, and two photos are looked at one after the other', async () => {
  const { looks } = workers();
  const scheduler = createScheduler();
  const masking = createMasking(photos, scheduler);
  const found = Promise.all([masking.findMask('a'), masking.findMask('b')]);
  await vi.advanceTimersByTimeAsync(100);
  expect(await found).toEqual(['mask 1', 'mask 2']);
  expect(looks).toEqual([1, 1, 1, 2, 2, 2]);
});

test('it rests while pages are drawn and a moment after, but not for ever', async () => {
  const { looks } = workers();
  const scheduler = createScheduler();
  const masking = createMasking(photos, scheduler);
  const first = masking.findMask('a');
  await vi.advanceTimersByTimeAsync(100);
  expect(await first).toBe('mask 1');
  const drawn = (ms: number) => {
    scheduler.hold(true);
    scheduler.hold(false);
    return vi.advanceTimersByTimeAsync(ms);
  };
  await drawn(0);
  const found = masking.findMask('b');
  await vi.advanceTimersByTimeAsync(900);
  expect(looks).toHaveLength(PARTS);
  await vi.advanceTimersByTimeAsync(200);
  expect(looks).toHaveLength(2 * PARTS);
  expect(await found).toBe('mask 2');

  await drawn(0);
  const third = masking.findMask('c');
  for (let shuffle = 0; shuffle < 3; shuffle += 1) await drawn(500);
  expect(looks).toHaveLength(2 * PARTS);
  // Each part waits two seconds at most.
  for (let shuffle = 0; shuffle < 3; shuffle += 1) await drawn(500);
  expect(looks).toHaveLength(2 * PARTS + 1);
  for (let shuffle = 0; shuffle < 8; shuffle += 1) await drawn(500);
  expect(await third).toBe('mask 3');
});

test('the net is given up a while after the last photo, and a look that is left is followed by the next', async () => {
  const { all } = workers();
  const scheduler = createScheduler();
  const masking = createMasking(photos, scheduler);
  const leaving = new AbortController();
  const left = masking.findMask('a', { signal: leaving.signal });
  left.catch(() => {});
  const next = masking.findMask('b');
  leaving.abort();
  await expect(left).rejects.toMatchObject({ name: 'AbortError' });
  await vi.advanceTimersByTimeAsync(100);
  expect(await next).toBe('mask 2');
  await vi.advanceTimersByTimeAsync(9_000);
  expect(all.map(({ ended }) => ended)).toEqual([false]);
  await vi.advanceTimersByTimeAsync(2_000);
  expect(all.map(({ ended }) => ended)).toEqual([true]);
});

test('the model is unloaded for another one, but not during a detection, nor before its file is stored', async () => {
  const { all } = workers();
  const scheduler = createScheduler();
  const masking = createMasking(photos, scheduler);
  const other = scheduler.createTicket({ unload: () => {} });
  const found = masking.findMask('a');
  await vi.advanceTimersByTimeAsync(0);
  const used = vi.fn(async () => {});
  const use = other.use(used);
  await vi.advanceTimersByTimeAsync(100);
  expect(await found).toBe('mask 1');
  await vi.advanceTimersByTimeAsync(7_000);
  expect(all.map(({ ended }) => ended)).toEqual([false]);
  expect(used).not.toHaveBeenCalled();
  await vi.advanceTimersByTimeAsync(1_500);
  await use;
  expect(all.map(({ ended }) => ended)).toEqual([true]);
});
