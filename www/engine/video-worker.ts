/**
 * Takes frames out of one video and ends with it: mediabunny finds the packets, the browser's WebCodecs decodes
 * them from the nearest key frame. The file is read in pieces, and a frame is closed as soon as it is copied, so a
 * long video takes no more memory than a short one. A worker of its own, so that it can be stopped at any moment; the
 * protocol is that of `frame-sender.ts`.
 */

import { ALL_FORMATS, BlobSource, Input, VideoSampleSink } from 'mediabunny';
import { rgbaOf } from './frame-pixels.ts';
import { mayGoOn, sendFrame, serveFrames } from './frame-sender.ts';
import { describe, failure } from './protocol.ts';
import { runs, sampleTimes } from './sample-times.ts';
import type { FileWish } from './frame-sender.ts';
import type { VideoSample } from 'mediabunny';

serveFrames(read);

async function read({ file, count, start, end, leading }: FileWish) {
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
    let delivered = false;
    try {
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
          delivered = true;
        }
      }
    } catch (error) {
      // Where not even one frame comes out of what it says it decodes, the browser's own player may do better.
      throw delivered ? error : failure('video-decoder', describe(error).message);
    }
  } finally {
    input.dispose();
  }
}

async function open(input: Input) {
  if (!(await input.canRead())) throw failure('video-format', 'It is not an MP4, MOV, WebM or Matroska video.');
  const track = await input.getPrimaryVideoTrack();
  if (!track) throw failure('video-empty', 'There is no picture in it, only sound.');
  if (!(await track.canDecode()))
    throw failure('video-decoder', `This browser cannot decode ${track.codec ?? 'its format'}.`);
  return track;
}

async function send(sample: VideoSample, index: number, time: number) {
  try {
    const { width, height, data } = await rgbaOf(sample.toVideoFrame());
    const { rotation, squarePixelWidth: squareWidth, squarePixelHeight: squareHeight } = sample;
    sendFrame({ index, time, width, height, squareWidth, squareHeight, rotation, data });
  } finally {
    sample.close();
  }
}
