/**
 * Shared protocol of workers that extract frames: one request, then frames with back-pressure.
 *
 * In: `{ file }` and the wish, then one `{ next: true }` for each frame that was dealt with.
 * Out: `{ about }`, then `{ frame }` for each, then `{ done: true }`; or `{ error: { code, message } }`.
 */

import { describe } from './protocol.ts';
import type { About, Frame, Wish } from './video.ts';

export type FileWish = Wish & { file: Blob };
/** Messages of the worker. */
export type FrameNews = { about?: About; frame?: Frame; done?: true; error?: { code: string; message: string } };

/** Maximum number of frames in transit. */
const AHEAD = 2;

let credit = AHEAD;
let wake: () => void = () => {};

/**
 * Answers this worker's messages.
 * @param read sends the frames
 */
export function serveFrames(read: (wish: FileWish) => Promise<void>) {
  globalThis.onmessage = async ({ data }: MessageEvent<FileWish & { next?: boolean }>) => {
    if (data.next) {
      credit += 1;
      wake();
      return;
    }
    try {
      await read(data);
      postMessage({ done: true });
    } catch (error) {
      postMessage({ error: describe(error) });
    }
  };
}

/** @returns when the page has dealt with enough of the frames before */
export function mayGoOn(): Promise<void> {
  if (credit > 0) return Promise.resolve();
  return new Promise((resolve) => {
    wake = resolve;
  });
}

/** @param frame its pixels are handed over */
export function sendFrame(frame: Frame) {
  credit -= 1;
  postMessage({ frame }, { transfer: [frame.data.buffer] });
}
