import { afterEach, expect, test, vi } from 'vitest';
import { createDetector } from './detector.ts';

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Workers that answer every message. */
function answeringWorkers({ offline = () => false }: { offline?: () => boolean } = {}) {
  const workers: { ended: boolean; asked: string[] }[] = [];
  class Answering {
    ended = false;
    asked: string[] = [];
    onmessage: ((event: { data: unknown }) => void) | undefined;
    constructor() {
      workers.push(this);
    }
    postMessage({ id, op }: { id: number; op: string }) {
      this.asked.push(op);
      const answer = offline()
        ? { error: { code: 'net-missing', message: 'no connection' } }
        : { ok: { boxes: [], closer: false } };
      queueMicrotask(() => this.onmessage?.({ data: { id, ...answer, memory: 0 } }));
    }
    terminate() {
      this.ended = true;
    }
  }
  vi.stubGlobal('Worker', Answering);
  return { workers, live: () => workers.filter(({ ended }) => !ended).length };
}

const photos = { get: () => ({ name: 'a.jpg', work: {} }) } as any;

test('where memory is short the nets are given up when all is looked at, and made anew for the next photo', async () => {
  vi.useFakeTimers();
  const { workers, live } = answeringWorkers();
  const detector = createDetector(photos, () => {}, 5_000);
  await detector.findFaces('a');
  expect(live()).toBe(2);
  vi.advanceTimersByTime(4_000);
  await detector.findFaces('b');
  vi.advanceTimersByTime(4_000);
  expect(live()).toBe(2);
  vi.advanceTimersByTime(2_000);
  expect([live(), detector.facesReady()]).toEqual([0, false]);
  await detector.findFaces('c');
  expect([live(), workers.length, detector.facesReady()]).toEqual([2, 4, true]);
});

test('while photos are chosen the net for faces looks at a blank picture, until there is one to look at', async () => {
  const { workers } = answeringWorkers();
  const looks = () => workers.flatMap(({ asked }) => asked.filter((op) => op === 'faces')).length;
  const chosen = createDetector(photos, () => {});
  chosen.prepare();
  await vi.waitFor(() => expect(chosen.facesReady()).toBe(true));
  expect(looks()).toBe(0);
  const choosing = createDetector(photos, () => {});
  choosing.prepare(true);
  choosing.prepare(true);
  await vi.waitFor(() => expect(looks()).toBe(12));
  const quick = createDetector(photos, () => {});
  quick.prepare(true);
  await quick.findFaces('a');
  expect(looks()).toBe(13);
});

test('they are given up when asked, but not while photos are looked at or on their way', async () => {
  vi.useFakeTimers();
  const { live } = answeringWorkers();
  const detector = createDetector(photos, () => {});
  const looking = detector.findFaces('a');
  detector.rest();
  await looking;
  expect(live()).toBe(2);
  detector.rest();
  // The delay before unloading the models for the next visit has not passed.
  vi.advanceTimersByTime(7_000);
  expect(live()).toBe(2);
  vi.advanceTimersByTime(2_000);
  expect([live(), detector.facesReady()]).toEqual([0, false]);
  detector.prepare();
  detector.rest();
  expect(live()).toBe(2);
});

test('nets that could be loaded long after their worker was started are kept, too', async () => {
  vi.useFakeTimers();
  let offline = true;
  const { live } = answeringWorkers({ offline: () => offline });
  const detector = createDetector(photos, () => {});
  await expect(detector.findFaces('a')).rejects.toMatchObject({ code: 'net-missing' });
  vi.advanceTimersByTime(30_000);
  offline = false;
  await detector.findFaces('a');
  detector.rest();
  vi.advanceTimersByTime(7_000);
  expect(live()).toBe(2);
  vi.advanceTimersByTime(2_000);
  expect(live()).toBe(0);
});

test('elsewhere they stay', async () => {
  vi.useFakeTimers();
  const { live } = answeringWorkers();
  await createDetector(photos, () => {}).findFaces('a');
  vi.advanceTimersByTime(60_000);
  expect(live()).toBe(2);
});
