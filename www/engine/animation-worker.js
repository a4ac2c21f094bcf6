// @ts-check
/**
 * Takes pictures out of one animated GIF or WebP file and ends with it. A worker of its own, so that it can be stopped
 * at any moment; the protocol is that of `frame-sender.js`.
 */

import { endsOf } from './animation-times.js';
import { rgbaOf } from './frame-pixels.js';
import { mayGoOn, sendFrame, serveFrames } from './frame-sender.js';
import { failure } from './protocol.js';
import { sampleTimes } from './sample-times.js';

serveFrames(read);

/** @param {import('./frame-sender.js').FileWish} wish */
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
    await mayGoOn();
    const { width, height, data } = await rgbaOf(picture);
    sendFrame({ index, time, width, height, squareWidth: width, squareHeight: height, rotation: 0, data });
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
