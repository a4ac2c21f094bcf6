// @ts-check
/**
 * Takes frames out of one video and ends with it: mediabunny finds the packets, the browser's WebCodecs decodes
 * them from the nearest key frame. The file is read in pieces, and a frame is closed as soon as it is copied, so a
 * long video takes no more memory than a short one. A worker of its own, so that it can be stopped at any moment.
 *
 * In: `{ file, count, start, end, leading }`, then one `{ next: true }` for each frame that was dealt with.
 * Out: `{ about }`, then `{ frame }` for each, then `{ done: true }`; or `{ error: { code, message } }`.
 */

import { ALL_FORMATS, BlobSource, Input, VideoSampleSink } from 'mediabunny';
import { describe, failure } from './protocol.js';
import { runs, sampleTimes } from './sample-times.js';

/** @typedef {import('./video.js').Wish} Wish */

/** Frames that may be on their way at once. */
const AHEAD = 2;

let credit = AHEAD;
/** @type {() => void} */
let wake = () => {};

/** @param {MessageEvent<Wish & { file: Blob, next?: boolean }>} event */
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

/** @param {Wish & { file: Blob }} wish */
async function read({ file, count, start, end, leading }) {
  if (typeof VideoDecoder === 'undefined') throw failure('video-decoder', 'This browser has no WebCodecs.');
  const input = new Input({ source: new BlobSource(file), formats: ALL_FORMATS });
  try {
    const track = await open(input);
    const first = Math.max(0, await track.getFirstTimestamp());
    const duration = await track.computeDuration();
    const times = sampleTimes({ first, duration, count, start, end });
    postMessage({ about: { duration } });
    // A slow film may show one frame at two of the times.
    const sent = new Set();
    for (const run of runs(times.length, leading)) {
      let next = 0;
      for await (const sample of new VideoSampleSink(track).samplesAtTimestamps(run.map((index) => times[index]))) {
        const index = run[next];
        next += 1;
        if (!sample || sent.has(sample.timestamp)) {
          sample?.close();
          continue;
        }
        sent.add(sample.timestamp);
        await mayGoOn();
        await send(sample, index, times[index]);
      }
    }
  } finally {
    input.dispose();
  }
}

/** @param {Input} input */
async function open(input) {
  if (!(await input.canRead())) throw failure('video-format', 'It is not an MP4, MOV, WebM or Matroska video.');
  const track = await input.getPrimaryVideoTrack();
  if (!track) throw failure('video-empty', 'There is no picture in it, only sound.');
  if (!(await track.canDecode())) throw failure('video-decoder', `This browser cannot decode ${track.codec ?? 'its format'}.`);
  return track;
}

/**
 * @param {import('mediabunny').VideoSample} sample
 * @param {number} index
 * @param {number} time
 */
async function send(sample, index, time) {
  try {
    const { width, height } = sample.visibleRect;
    const data = new Uint8Array(sample.allocationSize({ format: 'RGBA' }));
    await sample.copyTo(data, { format: 'RGBA' });
    const { rotation, squarePixelWidth: squareWidth, squarePixelHeight: squareHeight } = sample;
    const frame = { index, time, width, height, squareWidth, squareHeight, rotation, data };
    credit -= 1;
    postMessage({ frame }, { transfer: [data.buffer] });
  } finally {
    sample.close();
  }
}

/** @returns {Promise<void>} when the page has dealt with enough of the frames before */
function mayGoOn() {
  if (credit > 0) return Promise.resolve();
  return new Promise((resolve) => {
    wake = resolve;
  });
}
