import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { readVideo } from './video.ts';

let worker: any;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal(
    'Worker',
    class {
      ended = false;
      asked = 0;
      constructor() {
        worker = this;
      }
      postMessage() {
        this.asked += 1;
      }
      terminate() {
        this.ended = true;
      }
    },
  );
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const film = new File(['no film'], 'film.mp4', { type: 'video/mp4' });

async function begin(onFrame: (frame: any) => Promise<void>) {
  const outcome = vi.fn();
  readVideo(film, { count: 3 }, { onAbout: () => {}, onFrame }).then(
    () => outcome('read'),
    ({ code }) => outcome(code),
  );
  await vi.waitFor(() => expect(worker?.asked).toBe(1));
  return outcome;
}

test('a reader that says nothing for a minute is given up, with a reason', async () => {
  const outcome = await begin(async () => {});
  await vi.advanceTimersByTimeAsync(50_000);
  worker.onmessage({ data: { about: { duration: 1 } } });
  await vi.advanceTimersByTimeAsync(50_000);
  expect(outcome).not.toHaveBeenCalled();
  await vi.advanceTimersByTimeAsync(20_000);
  expect(outcome).toHaveBeenCalledWith('video-worker');
  expect(worker.ended).toBe(true);
});

test('it is not to blame while its frames wait for the page', async () => {
  let dealt = () => {};
  const outcome = await begin(
    () =>
      new Promise((resolve) => {
        dealt = () => resolve();
      }),
  );
  worker.onmessage({ data: { frame: { index: 0 } } });
  await vi.advanceTimersByTimeAsync(600_000);
  expect(outcome).not.toHaveBeenCalled();
  dealt();
  await vi.advanceTimersByTimeAsync(50_000);
  expect(outcome).not.toHaveBeenCalled();
  worker.onmessage({ data: { done: true } });
  await vi.advanceTimersByTimeAsync(0);
  expect(outcome).toHaveBeenCalledWith('read');
});
