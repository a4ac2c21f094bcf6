import { afterEach, describe, expect, test, vi } from 'vitest';
import { createPool } from './pool.ts';
import { TRAP } from './protocol.ts';
import { Priority } from './queue.ts';
import { caught, fakeWorkers, job } from './testing.ts';
import type { Named } from './testing.ts';

afterEach(() => void vi.useRealTimers());

describe('order', () => {
  test('what the person looks at comes first, then first come first served', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const order: string[] = [];
    const all = [
      pool.run(job('busy')),
      pool.run(job('rest', { priority: Priority.REST })),
      pool.run(job('view 1')),
      pool.run(job('panel', { priority: Priority.PANEL })),
      pool.run(job('view 2')),
    ].map((promise) => promise.then((name) => order.push(name)));
    for (const name of ['busy', 'panel', 'view 1', 'view 2', 'rest']) {
      fakes.answer(name);
      await Promise.resolve();
    }
    await Promise.all(all);
    expect(order).toEqual(['busy', 'panel', 'view 1', 'view 2', 'rest']);
  });

  test('thumbnails leave a worker that is spared alone, what a person waits for does not', () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 2, spawn: fakes.spawn });
    pool.spare(1);
    for (const name of ['a', 'b']) pool.run(job(name));
    const running = () => ['a', 'b', 'page'].filter((name) => fakes.holding(name));
    expect(running()).toEqual(['a']);
    pool.run(job('page', { priority: Priority.PANEL }));
    expect(running()).toEqual(['a', 'page']);
    fakes.answer('page');
    expect(running()).toEqual(['a']);
    pool.spare(0);
    expect(running()).toEqual(['a', 'b']);
    // A single worker is never spared.
    const single = fakeWorkers();
    const small = createPool<Named>({ size: 1, spawn: single.spawn });
    small.spare(1);
    small.run(job('only'));
    expect(!!single.holding('only')).toBe(true);
  });

  test('what the page does not wait for is kept while it is held, and done after', () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 2, spawn: fakes.spawn });
    pool.hold(true);
    pool.run(job('rest', { priority: Priority.REST }));
    pool.run(job('view', { priority: Priority.VIEW }));
    pool.run(job('page', { priority: Priority.PAGE }));
    const running = () => ['rest', 'view', 'page'].filter((name) => fakes.holding(name));
    expect(running()).toEqual(['page']);
    fakes.answer('page');
    expect(running()).toEqual([]);
    pool.hold(false);
    expect(running()).toEqual(['rest', 'view']);
  });

  test('a promoted job overtakes the others, also while low-priority work is held', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    let promote = () => {};
    const promoted = new Promise<void>((resolve) => {
      promote = resolve;
    });
    for (const name of ['busy', 'view']) pool.run(job(name));
    pool.run(job('ahead', { priority: Priority.REST, promoted }));
    pool.hold(true);
    fakes.answer('busy');
    expect(fakes.holding('ahead')).toBeUndefined();
    promote();
    await promoted;
    expect(!!fakes.holding('ahead')).toBe(true);
  });

  test('as many jobs run at once as there are workers', () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 2, spawn: fakes.spawn });
    for (const name of ['a', 'b', 'c']) pool.run(job(name));
    expect([!!fakes.holding('a'), !!fakes.holding('b'), !!fakes.holding('c')]).toEqual([true, true, false]);
  });

  test('a worker takes the job whose photo it holds, among equals only', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    pool.run(job('first', { holds: ['p1'] }));
    pool.run(job('other', { holds: ['p2'] }));
    pool.run(job('same', { holds: ['p1'] }));
    pool.run(job('urgent', { holds: ['p3'], priority: Priority.PANEL }));
    fakes.answer('first');
    expect(fakes.holding('urgent')).toBeTruthy();
    fakes.answer('urgent');
    expect(fakes.holding('same')).toBeTruthy();
  });
});

describe('what is overtaken or cancelled', () => {
  test('a newer job of the same key wins over a waiting one and over a running one', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const running = caught(pool.run(job('one', { key: 'panel/0' })));
    const waiting = caught(pool.run(job('two', { key: 'panel/0' })));
    const newest = pool.run(job('three', { key: 'panel/0' }));
    expect(await running).toBe('cancelled');
    expect(await waiting).toBe('cancelled');
    expect(fakes.holding('two')).toBeFalsy();
    fakes.answer('one');
    fakes.answer('three');
    expect(await newest).toBe('three');
  });

  test('an aborted job leaves the queue and never reaches a worker', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const stop = new AbortController();
    pool.run(job('busy'));
    const waiting = caught(pool.run(job('waiting', { signal: stop.signal })));
    const last = pool.run(job('last'));
    stop.abort();
    expect(await waiting).toBe('cancelled');
    fakes.answer('busy');
    expect(fakes.holding('waiting')).toBeFalsy();
    fakes.answer('last');
    expect(await last).toBe('last');
  });

  test('a signal that was aborted before costs nothing', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    expect(await caught(pool.run(job('late', { signal: AbortSignal.abort() })))).toBe('cancelled');
    expect(fakes.holding('late')).toBeFalsy();
  });

  test('an aborted running job of a large image gives its worker up within 100 ms, for the next job', async () => {
    vi.useFakeTimers();
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const stop = new AbortController();
    const running = caught(pool.run(job('export', { signal: stop.signal, priority: Priority.PAGE })));
    const next = pool.run(job('next'));
    const [busy] = fakes.workers;
    stop.abort();
    expect(await running).toBe('cancelled');
    expect(busy.dead).toBe(false);
    vi.advanceTimersByTime(100);
    expect(busy.dead).toBe(true);
    expect(fakes.workers.length).toBe(2);
    fakes.answer('next');
    expect(await next).toBe('next');
  });

  test('one that answers at once after all keeps its worker, and so does the job after it', async () => {
    vi.useFakeTimers();
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const stop = new AbortController();
    const running = caught(pool.run(job('export', { signal: stop.signal, priority: Priority.PAGE })));
    stop.abort();
    expect(await running).toBe('cancelled');
    const next = pool.run(job('next', { priority: Priority.PAGE }));
    fakes.answer('export');
    vi.advanceTimersByTime(100);
    expect(fakes.workers.length).toBe(1);
    fakes.answer('next');
    expect(await next).toBe('next');
  });

  test('an aborted running thumbnail keeps its worker busy until it answers', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const stop = new AbortController();
    const running = caught(pool.run(job('running', { signal: stop.signal })));
    stop.abort();
    expect(await running).toBe('cancelled');
    pool.run(job('next'));
    expect(fakes.holding('next')).toBeFalsy();
    fakes.answer('running');
    expect(fakes.holding('next')).toBeTruthy();
  });
});

describe('workers that die', () => {
  test('a trap replaces the worker and the job is tried once more', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const result = pool.run(job('photo', { photo: 'beach.jpg' }));
    fakes.answer('photo', { error: { code: TRAP, message: 'unreachable' } });
    expect(fakes.workers.length).toBe(2);
    fakes.answer('photo');
    expect(await result).toBe('photo');
  });

  test("the second try is the fresh worker's, though another is idle", async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 2, spawn: fakes.spawn });
    const [one, two] = [pool.run(job('one')), pool.run(job('two'))];
    fakes.answer('one');
    fakes.answer('two', { error: { code: TRAP, message: 'unreachable' } });
    expect(fakes.holding('two')).toBe(fakes.workers[2]);
    fakes.answer('two');
    expect(await Promise.all([one, two])).toEqual(['one', 'two']);
  });

  test("a second trap is the photo's fault, and the rest goes on", async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const result = pool.run(job('photo', { photo: 'beach.jpg' })).catch((error) => error);
    const next = pool.run(job('next'));
    fakes.answer('photo', { error: { code: TRAP, message: 'unreachable' } });
    fakes.live()[0].onerror({ preventDefault() {} });
    expect(await result).toMatchObject({ code: 'worker-lost', photo: 'beach.jpg' });
    expect((await result).message).toContain('beach.jpg');
    fakes.answer('next');
    expect(await next).toBe('next');
  });

  test('an ordinary error keeps the worker', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const result = pool.run(job('bad', { photo: 'notes.txt' })).catch((error) => error);
    fakes.answer('bad', { error: { code: 'unsupported-format', message: 'not a photo' } });
    expect(await result).toMatchObject({ code: 'unsupported-format', message: 'not a photo', photo: 'notes.txt' });
    expect(fakes.workers.length).toBe(1);
  });

  test('a worker whose memory grew too large is replaced between jobs', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn, highWater: 100 });
    const result = pool.run(job('large'));
    fakes.answer('large', { ok: 'fine', memory: 101 });
    expect(await result).toBe('fine');
    expect([fakes.workers.length, fakes.live().length]).toEqual([2, 1]);
  });

  test('a worker whose memory is more than it may keep at rest is replaced once nothing waits', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn, highWater: 100, restWater: 50 });
    const results = [pool.run(job('first')), pool.run(job('last')), pool.run(job('small'))];
    fakes.answer('first', { ok: 1, memory: 60 });
    expect(fakes.workers.length).toBe(1);
    fakes.answer('last', { ok: 2, memory: 60 });
    expect(fakes.workers.length).toBe(1);
    fakes.answer('small', { ok: 3, memory: 60 });
    expect(await Promise.all(results)).toEqual([1, 2, 3]);
    expect([fakes.workers.length, fakes.live().length]).toEqual([2, 1]);
  });

  test('an idle worker that dies is replaced only when it is needed', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    fakes.workers[0].onerror({ preventDefault() {} });
    expect(fakes.workers.length).toBe(1);
    const result = pool.run(job('next'));
    fakes.answer('next');
    expect(await result).toBe('next');
    expect(fakes.workers.length).toBe(2);
  });

  test('a disposed pool cancels what is left and terminates its workers', async () => {
    const fakes = fakeWorkers();
    const pool = createPool<Named>({ size: 1, spawn: fakes.spawn });
    const left = [caught(pool.run(job('a'))), caught(pool.run(job('b')))];
    pool.dispose();
    expect(await Promise.all(left)).toEqual(['cancelled', 'cancelled']);
    expect(fakes.live().length).toBe(0);
    expect(await caught(pool.run(job('c')))).toBe('disposed');
  });
});
