/**
 * A worker that streams: it gets one request, sends several messages, and ends with a result. Some messages ask for an
 * answer, and the worker waits for it. The worker ends with its stream.
 */

import { cancelled } from './protocol.ts';
import { timeLimit } from './scheduler.ts';

/** Maximum milliseconds without a message. A slow device may work on hundreds of frames between two messages. */
const SILENCE = 60_000;

/** Ends the stream with a result. */
export type End<Ok> = { resolve: (result: Ok | Promise<Ok>) => void; reject: (error: Error) => void };
/** An answer to the worker, and its buffers. */
export type Answer = { message: object; transfer?: Transferable[] };

/**
 * @param worker terminated at the end
 * @param request its first message
 * @param options `lost`: the error of a worker that crashes or hangs. `onMessage` returns a promise of the answer, if the
 *   message asks for one. The time until then does not count
 */
export async function stream<News, Ok>(
  worker: Worker,
  { message, transfer = [] }: Answer,
  {
    signal,
    lost,
    onMessage,
  }: { signal?: AbortSignal; lost: () => Error; onMessage: (news: News, end: End<Ok>) => Promise<Answer> | void },
): Promise<Ok> {
  let answering = 0;
  let stop = () => {};
  try {
    return await new Promise<Ok>((resolve, reject) => {
      const listen = () => {
        stop();
        stop = answering > 0 ? () => {} : timeLimit(SILENCE, () => reject(lost()));
      };
      if (signal?.aborted) reject(cancelled());
      signal?.addEventListener('abort', () => reject(cancelled()), { once: true });
      worker.onerror = (event) => {
        event.preventDefault();
        reject(lost());
      };
      worker.onmessage = ({ data }: MessageEvent<News>) => {
        const answer = onMessage(data, { resolve, reject });
        if (answer) {
          answering += 1;
          answer.then((next) => {
            answering -= 1;
            listen();
            worker.postMessage(next.message, next.transfer ?? []);
          }, reject);
        }
        listen();
      };
      listen();
      worker.postMessage(message, transfer);
    });
  } finally {
    // No later answer sets a time limit.
    answering = Infinity;
    stop();
    worker.terminate();
  }
}
