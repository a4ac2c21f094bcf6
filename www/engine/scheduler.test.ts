import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { createScheduler, timeLimit } from './scheduler.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('the limit is kept', () => {
  const over = vi.fn();
  timeLimit(30_000, over);
  vi.advanceTimersByTime(29_999);
  expect(over).not.toHaveBeenCalled();
  vi.advanceTimersByTime(1);
  expect(over).toHaveBeenCalledTimes(1);
});

test('a device that slept for an hour has used up one part', () => {
  const over = vi.fn();
  timeLimit(30_000, over);
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
  const stop = timeLimit(30_000, over);
  vi.advanceTimersByTime(20_000);
  stop();
  vi.advanceTimersByTime(60_000);
  expect(over).not.toHaveBeenCalled();
});

describe('lanes', () => {
  test('visible work starts at once, requested work when the page is drawn, background work after a rest', async () => {
    const { hold, turn } = createScheduler();
    const order: string[] = [];
    hold(true);
    for (const lane of ['background', 'requested', 'visible'] as const) void turn(lane).then(() => order.push(lane));
    await vi.advanceTimersByTimeAsync(100);
    expect(order).toEqual(['visible']);
    hold(false);
    await vi.advanceTimersByTimeAsync(100);
    expect(order).toEqual(['visible', 'requested']);
    await vi.advanceTimersByTimeAsync(300);
    expect(order).toEqual(['visible', 'requested', 'background']);
  });

  test('every drawn page delays background work, but not for ever', async () => {
    const { hold, background } = createScheduler();
    const task = vi.fn();
    background(task);
    for (let shuffle = 0; shuffle < 29; shuffle += 1) {
      hold(true);
      await vi.advanceTimersByTimeAsync(100);
      hold(false);
      await vi.advanceTimersByTimeAsync(100);
    }
    expect(task).not.toHaveBeenCalled();
    hold(true);
    await vi.advanceTimersByTimeAsync(300);
    expect(task).toHaveBeenCalledTimes(1);
  });

  test('a page that is never drawn holds the other lanes for three seconds', async () => {
    const { hold, turn, follow } = createScheduler();
    const changes: boolean[] = [];
    const end = follow((on) => changes.push(on));
    const done = vi.fn();
    hold(true);
    void turn('requested').then(done);
    await vi.advanceTimersByTimeAsync(2_900);
    expect(done).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(200);
    expect(done).toHaveBeenCalledTimes(1);
    end();
    hold(true);
    expect(changes).toEqual([true, false]);
  });

  test('a task that is cancelled before its turn does not start', async () => {
    const { background, turn } = createScheduler();
    const stop = new AbortController();
    const task = vi.fn();
    background(task, { delay: 1_000, signal: stop.signal });
    const waiting = turn('background', { delay: 1_000, signal: stop.signal });
    stop.abort();
    await expect(waiting).rejects.toMatchObject({ name: 'AbortError' });
    await expect(turn('visible', stop)).rejects.toMatchObject({ name: 'AbortError' });
    await vi.advanceTimersByTimeAsync(20_000);
    expect(task).not.toHaveBeenCalled();
  });
});

describe('memory of models', () => {
  /** A model, and work that lasts some time. */
  function model(scheduler: ReturnType<typeof createScheduler>, options: { storing?: number; linger?: number } = {}) {
    const unload = vi.fn();
    const ticket = scheduler.createTicket({ unload, ...options });
    const work = (ms: number) => () => new Promise<void>((resolve) => void setTimeout(resolve, ms));
    return { unload, ...ticket, work };
  }

  test('one model is in memory at a time, and an idle one is unloaded for the next', async () => {
    const scheduler = createScheduler();
    const [one, two] = [model(scheduler), model(scheduler)];
    void one.use(one.work(1_000));
    const work = vi.fn(async () => {});
    void two.use(work);
    await vi.advanceTimersByTimeAsync(900);
    expect(work).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(200);
    expect(work).toHaveBeenCalledTimes(1);
    expect(one.unload).toHaveBeenCalledTimes(1);
  });

  test('a model is unloaded some time after its last use', async () => {
    const { use, work, unload } = model(createScheduler());
    void use(work(0));
    await vi.advanceTimersByTimeAsync(9_000);
    void use(work(0));
    await vi.advanceTimersByTimeAsync(9_000);
    expect(unload).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(2_000);
    expect(unload).toHaveBeenCalledTimes(1);
  });

  test('requests of the user come before background work, which does not unload the model of the user', async () => {
    const scheduler = createScheduler();
    const [masks, scores] = [model(scheduler), model(scheduler)];
    const order: string[] = [];
    const note = (name: string, work: () => Promise<void>) => () => {
      order.push(name);
      return work();
    };
    void masks.use(note('mask', masks.work(1_000)));
    void scores.use(note('score', scores.work(100)), { lane: 'requested' });
    await vi.advanceTimersByTimeAsync(500);
    void masks.use(note('mask', masks.work(0)));
    await vi.advanceTimersByTimeAsync(1_000);
    void scores.use(note('score', scores.work(100)), { lane: 'requested' });
    await vi.advanceTimersByTimeAsync(9_000);
    expect(order).toEqual(['mask', 'score', 'score']);
    await vi.advanceTimersByTimeAsync(2_000);
    expect(order).toEqual(['mask', 'score', 'score', 'mask']);
  });

  test('work that fails or is cancelled frees the memory', async () => {
    const scheduler = createScheduler();
    const [one, two] = [model(scheduler), model(scheduler)];
    await expect(one.use(() => Promise.reject(new Error('broken')))).rejects.toThrow('broken');
    const stop = new AbortController();
    void one.use(one.work(1_000));
    const waiting = two.use(async () => {}, stop);
    stop.abort();
    await expect(waiting).rejects.toMatchObject({ name: 'AbortError' });
    await vi.advanceTimersByTimeAsync(1_000);
    await two.use(async () => {});
    expect(one.unload).toHaveBeenCalledTimes(1);
  });
});
