import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { stream } from './streaming.ts';
import type { Answer } from './streaming.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const lost = () => Object.assign(new Error('lost'), { code: 'lost' });

function begun(onMessage: (news: string, end: any) => Promise<Answer> | void, signal?: AbortSignal) {
  const sent: object[] = [];
  const worker: any = { sent, ended: false, postMessage: (message: object) => sent.push(message) };
  worker.terminate = () => {
    worker.ended = true;
  };
  const outcome = vi.fn();
  stream<string, string>(worker, { message: { begin: true } }, { signal, lost, onMessage }).then(outcome, ({ code }) =>
    outcome(code),
  );
  return { worker, outcome, say: (data: string) => worker.onmessage({ data }) };
}

test('the worker gets answers, and ends with its result', async () => {
  const { worker, outcome, say } = begun((news, { resolve }) => {
    if (news === 'wants') return Promise.resolve({ message: { answer: true } });
    return resolve(news);
  });
  say('wants');
  await vi.advanceTimersByTimeAsync(0);
  expect(worker.sent).toEqual([{ begin: true }, { answer: true }]);
  say('file');
  await vi.advanceTimersByTimeAsync(0);
  expect(outcome).toHaveBeenCalledWith('file');
  expect(worker.ended).toBe(true);
  expect(vi.getTimerCount()).toBe(0);
});

test('a worker that is silent for a minute is lost, but not while it waits for an answer', async () => {
  let answer = (_: Answer) => {};
  const { outcome, say } = begun(
    () =>
      new Promise((resolve) => {
        answer = resolve;
      }),
  );
  await vi.advanceTimersByTimeAsync(50_000);
  say('wants');
  await vi.advanceTimersByTimeAsync(100_000);
  expect(outcome).not.toHaveBeenCalled();
  answer({ message: {} });
  await vi.advanceTimersByTimeAsync(61_000);
  expect(outcome).toHaveBeenCalledWith('lost');
});

test('a stream can be cancelled', async () => {
  const stop = new AbortController();
  const { worker, outcome } = begun(() => undefined, stop.signal);
  stop.abort();
  await vi.advanceTimersByTimeAsync(0);
  expect(outcome).toHaveBeenCalledWith('cancelled');
  expect(worker.ended).toBe(true);
});
