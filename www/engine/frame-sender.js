// @ts-check
/**
 * What the workers that take frames out of a file have in common: one wish, then frames no faster than they are dealt
 * with.
 *
 * In: `{ file, count, start, end, leading }`, then one `{ next: true }` for each frame that was dealt with.
 * Out: `{ about }`, then `{ frame }` for each, then `{ done: true }`; or `{ error: { code, message } }`.
 */

import { describe } from './protocol.js';

/** @typedef {import('./video.js').Wish & { file: Blob }} FileWish */

/** Frames that may be on their way at once. */
const AHEAD = 2;

let credit = AHEAD;
/** @type {() => void} */
let wake = () => {};

/**
 * Answers this worker's messages.
 * @param {(wish: FileWish) => Promise<void>} read sends the frames
 */
export function serveFrames(read) {
  globalThis.onmessage = async (/** @type {MessageEvent<FileWish & { next?: boolean }>} */ { data }) => {
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

/** @returns {Promise<void>} when the page has dealt with enough of the frames before */
export function mayGoOn() {
  if (credit > 0) return Promise.resolve();
  return new Promise((resolve) => {
    wake = resolve;
  });
}

/** @param {import('./video.js').Frame} frame its pixels are handed over */
export function sendFrame(frame) {
  credit -= 1;
  postMessage({ frame }, { transfer: [frame.data.buffer] });
}
