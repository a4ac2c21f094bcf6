import { afterEach, expect, test, vi } from 'vitest';
import { createDetector } from './detector.ts';
import { createScheduler } from './scheduler.ts';

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

/** A detector, and a ticket for another model. */
function opened({ linger = Infinity, workers = 2 } = {}) {
  const scheduler = createScheduler();
  const other = scheduler.createTicket({ unload: () => {} });
  return { detector: createDetector(photos, { scheduler, workers, spare: () => {}, linger }), other };
}

const photos = { get: () => ({ name: 'a.jpg', work: {} }) } as any;

test('where memory is short the nets are given up when all is looked at, and made anew for the next photo', async () => {
  vi.useFakeTimers();
  const { workers, live } = answeringWorkers();
  const { detector } = opened({ linger: 5_000 });
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

test('one worker has both models, and requests each file once', async () => {
  const { workers, live } = answeringWorkers();
  const { detector } = opened({ workers: 1 });
  await Promise.all([detector.findFaces('a'), detector.findObjects('a'), detector.findFaces('b')]);
  const count = (op: string) => workers[0].asked.filter((asked) => asked === op).length;
  expect([live(), count('load'), count('make'), count('faces'), count('objects')]).toEqual([1, 2, 2, 2, 1]);
});

test('while photos are chosen the net for faces looks at a blank picture, until there is one to look at', async () => {
  const { workers } = answeringWorkers();
  const looks = () => workers.flatMap(({ asked }) => asked.filter((op) => op === 'faces')).length;
  const { detector: chosen } = opened();
  chosen.prepare();
  await vi.waitFor(() => expect(chosen.facesReady()).toBe(true));
  expect(looks()).toBe(0);
  const { detector: choosing } = opened();
  choosing.prepare(true);
  choosing.prepare(true);
  await vi.waitFor(() => expect(looks()).toBe(12));
  const { detector: quick } = opened();
  quick.prepare(true);
  await quick.findFaces('a');
  expect(looks()).toBe(13);
});

test('the models are unloaded for another one, but not during a detection, nor before their files are stored', async () => {
  vi.useFakeTimers();
  const { live } = answeringWorkers();
  const { detector, other } = opened();
  const looking = detector.findFaces('a');
  const used = other.use(async () => {});
  await looking;
  await vi.advanceTimersByTimeAsync(7_000);
  expect(live()).toBe(2);
  await vi.advanceTimersByTimeAsync(2_000);
  await used;
  expect([live(), detector.facesReady()]).toEqual([0, false]);
});

test('models that could be loaded long after their worker was started are stored, too', async () => {
  vi.useFakeTimers();
  let offline = true;
  const { live } = answeringWorkers({ offline: () => offline });
  const { detector, other } = opened();
  await expect(detector.findFaces('a')).rejects.toMatchObject({ code: 'net-missing' });
  vi.advanceTimersByTime(30_000);
  offline = false;
  await detector.findFaces('a');
  const used = other.use(async () => {});
  await vi.advanceTimersByTimeAsync(7_000);
  expect(live()).toBe(2);
  await vi.advanceTimersByTimeAsync(2_000);
  await used;
  expect(live()).toBe(0);
});

test('elsewhere they stay', async () => {
  vi.useFakeTimers();
  const { live } = answeringWorkers();
  await opened().detector.findFaces('a');
  vi.advanceTimersByTime(60_000);
  expect(live()).toBe(2);
});
