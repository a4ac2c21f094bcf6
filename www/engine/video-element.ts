/**
 * The slow way to the frames of a video, for browsers without WebCodecs or without the codec there: a hidden muted
 * `<video>` is wound to each time. `seeked` fires before the frame is available, so the code waits for the frame
 * callback.
 */

import { cancelled, failure } from './protocol.ts';
import { runs, sampleTimes } from './sample-times.ts';
import { after, pause } from './scheduler.ts';
import type { Listener, Wish } from './video.ts';

/** Maximum wait for a frame in milliseconds. After that the current image is used. */
const PATIENCE = 1500;
/** Default number of frames. */
const USUAL = 24;
/** Maximum milliseconds for opening a video. */
const OPENING = 10_000;

/** @param why the fast way failed */
export async function readByElement(
  file: Blob,
  { count, start, end, leading, times: told }: Wish,
  { signal, onAbout, onFrame }: Listener,
  why: string,
) {
  const video = document.createElement('video');
  video.muted = true;
  video.playsInline = true;
  video.preload = 'auto';
  const address = URL.createObjectURL(file);
  try {
    video.src = address;
    const opened = await happens(video, 'loadeddata', OPENING);
    // Without a codec, a video may load without an error, but has no picture.
    if (!opened || video.videoWidth === 0) throw failure('video-codec', why);
    const whole = await lengthOf(video);
    const first = await wind(video, 0);
    // If a player does not report displayed frames, the video starts with the first one.
    const begins = first < whole ? first : 0;
    const duration = whole - begins;
    onAbout({ duration });
    const times = told ?? sampleTimes({ first: 0, duration, count: count || USUAL, start, end });
    for (const index of runs(times.length, leading).flat()) {
      const time = times[index];
      if (signal?.aborted) throw cancelled();
      await wind(video, begins + time);
      await onFrame({ index, time, rotation: 0, ...(await pixelsOf(video)) });
    }
  } finally {
    video.removeAttribute('src');
    video.load();
    URL.revokeObjectURL(address);
  }
}

/** Recordings of a browser have no length until a seek to the end. */
async function lengthOf(video: HTMLVideoElement) {
  if (Number.isFinite(video.duration)) return video.duration;
  const known = happens(video, 'durationchange', OPENING);
  video.currentTime = 1e9;
  await known;
  if (!Number.isFinite(video.duration)) throw failure('video-format', 'Its length cannot be found.');
  return video.duration;
}

/** @param time seconds @returns the start of the frame at that time; `time` if it is unknown */
async function wind(video: HTMLVideoElement, time: number) {
  const shown = new Promise<number>((resolve) => {
    const told = 'requestVideoFrameCallback' in video;
    if (told) video.requestVideoFrameCallback((_, { mediaTime }) => resolve(mediaTime));
    else (video as HTMLVideoElement).addEventListener('seeked', () => resolve(time), { once: true });
  });
  video.currentTime = time;
  return Promise.race([shown, pause(PATIENCE).then(() => time)]);
}

async function pixelsOf(video: HTMLVideoElement): Promise<{
  width: number;
  height: number;
  squareWidth: number;
  squareHeight: number;
  data: Uint8Array<ArrayBuffer>;
}> {
  const { videoWidth: width, videoHeight: height } = video;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw failure('video-memory', 'There is not enough memory for a frame.');
  context.drawImage(video, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  return { width, height, squareWidth: width, squareHeight: height, data: new Uint8Array(data.buffer) };
}

/**
 * @param patience ms
 * @returns whether the event came within the time limit, and before an error
 */
function happens(video: HTMLVideoElement, event: string, patience: number): Promise<boolean> {
  return new Promise((resolve) => {
    video.addEventListener(event, () => resolve(true), { once: true });
    video.addEventListener('error', () => resolve(false), { once: true });
    after(patience, () => resolve(false));
  });
}
