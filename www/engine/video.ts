/**
 * Frames of a video, in sequence: by WebCodecs in a worker, or by a hidden `<video>` that seeks to each time, if the
 * browser lacks WebCodecs or the codec. An animated GIF or WebP file is read likewise, by the browser's decoder of
 * images.
 */

import { pictureEnds } from './animation-times.ts';
import { failure } from './protocol.ts';
import { stream } from './streaming.ts';
import { readByElement } from './video-element.ts';

import type { FrameNews } from './frame-sender.ts';

export { isVideo } from './is-video.ts';

/**
 * `count` frames between `start` and `end`, in seconds; default: the whole video. `leading` are the indices of urgent
 * frames. `times`: exactly these frames. `shots`: representative frames of the shots, an automatic number if `count` is
 * 0. `moments`, in seconds, should have a frame close to them.
 */
export type Wish = {
  count: number;
  start?: number;
  end?: number;
  leading?: readonly number[];
  times?: readonly number[];
  shots?: boolean;
  moments?: readonly number[];
};
/**
 * Known properties of the video: `duration` in seconds; `whole`: the stated duration of a truncated file; `looked`:
 * analysed share, 0 to 1; `frames`: number of frames. `shots` has indices of earlier frames and their shot numbers, which
 * change with the analysis.
 */
export type About = {
  duration: number;
  whole?: number;
  looked?: number;
  frames?: number;
  shots?: readonly (readonly [index: number, shot: number])[];
};
/** RGBA of `width` x `height` pixels, to be stretched to the square size and turned clockwise by `rotation` */
export type Frame = {
  index: number;
  time: number;
  /** from 1 */
  shot?: number;
  width: number;
  height: number;
  squareWidth: number;
  squareHeight: number;
  rotation: number;
  data: Uint8Array<ArrayBuffer>;
};
/** The next frame is requested when the promise of `onFrame` settles. */
export type Listener = {
  signal?: AbortSignal;
  onAbout: (about: About) => void;
  onFrame: (frame: Frame) => Promise<void>;
};

/** Errors of files that the browser's player may still read. */
const BY_ELEMENT = ['film-codec', 'film-empty', 'film-cut'];

/** @returns when all frames were dealt with */
export async function readVideo(file: Blob, wish: Wish, listener: Listener): Promise<void> {
  if (file.size === 0) throw failure('film-empty', 'The file is empty.');
  if ((await pictureEnds(file)).length > 0) {
    const worker = new Worker(new URL('./animation-worker.ts', import.meta.url), {
      type: 'module',
      name: 'inkpanel-animation',
    });
    return readByWorker(worker, { file, ...wish }, listener);
  }
  try {
    const worker = new Worker(new URL('./video-worker.ts', import.meta.url), {
      type: 'module',
      name: 'inkpanel-video',
    });
    await readByWorker(worker, { file, ...wish }, listener);
  } catch (error) {
    const { code, message } = error as { code?: string; message: string };
    if (code !== 'video-decoder' && !BY_ELEMENT.includes(String(code))) throw error;
    await readByElement(file, wish, listener, message).catch((worse) => {
      // If the browser's player fails as well, report the error of the video.
      throw code !== 'video-decoder' && worse.code === 'video-codec' ? error : worse;
    });
  }
}

/** @param worker which ends with it */
function readByWorker(worker: Worker, message: object, { signal, onAbout, onFrame }: Listener): Promise<void> {
  const busy: Promise<void>[] = [];
  const lost = () => failure('video-worker', 'Its reader stopped.');
  return stream<FrameNews, void>(
    worker,
    { message },
    {
      signal,
      lost,
      onMessage({ about, frame, done, error }, { resolve, reject }) {
        if (about) onAbout(about);
        if (error) reject(failure(error.code, error.message));
        if (done) resolve(Promise.all(busy).then(() => {}));
        if (!frame) return undefined;
        const dealt = onFrame(frame);
        busy.push(dealt);
        return dealt.then(() => ({ message: { next: true } }));
      },
    },
  );
}
