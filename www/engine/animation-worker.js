// @ts-check
/**
 * Takes pictures out of one animated GIF or WebP file and ends with it. A worker of its own, so that it can be stopped
 * at any moment; the protocol is that of `video-worker.js`.
 *
 * In: `{ file, count, start, end }`, then one `{ next: true }` for each picture that was dealt with.
 * Out: `{ about }`, then `{ frame }` for each, then `{ done: true }`; or `{ error: { code, message } }`.
 */

import { endsOf } from './animation-times.js';
import { rgbaOf } from './frame-pixels.js';
import { describe, failure } from './protocol.js';
import { sampleTimes } from './sample-times.js';

/** Pictures that may be on their way at once. */
const AHEAD = 2;

let credit = AHEAD;
/** @type {() => void} */
let wake = () => {};

/** @param {MessageEvent<import('./video.js').Wish & { file: Blob, next?: boolean }>} event */
globalThis.onmessage = async ({ data }) => {
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

/** @param {import('./video.js').Wish & { file: Blob }} wish */
async function read({ file, count, start, end }) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const ends = endsOf(bytes);
  const duration = ends[ends.length - 1] ?? 0;
  const decoder = new ImageDecoder({ type: bytes[0] === 0x47 ? 'image/gif' : 'image/webp', data: bytes });
  postMessage({ about: { duration } });
  let last = -1;
  for (const [index, time] of sampleTimes({ first: 0, duration, count, start, end }).entries()) {
    const later = ends.findIndex((till) => time < till);
    const shown = later < 0 ? ends.length - 1 : later;
    // A slow animation may show one picture at two of the times.
    if (shown === last) continue;
    const picture = await pictureOf(decoder, shown, last < 0);
    if (!picture) return;
    last = shown;
    if (credit === 0) await new Promise((/** @type {(value?: any) => void} */ resolve) => (wake = resolve));
    const { width, height, data } = await rgbaOf(picture);
    credit -= 1;
    const frame = { index, time, width, height, squareWidth: width, squareHeight: height, rotation: 0, data };
    postMessage({ frame }, { transfer: [data.buffer] });
  }
}

/**
 * A file that breaks off ends with its last whole picture; one without any is an error.
 * @param {ImageDecoder} decoder
 * @param {number} frameIndex
 * @param {boolean} needed
 */
async function pictureOf(decoder, frameIndex, needed) {
  try {
    return (await decoder.decode({ frameIndex })).image;
  } catch {
    if (needed) throw failure('damaged', 'The animation is damaged or cut short.');
    return null;
  }
}
