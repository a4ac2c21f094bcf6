/**
 * Animated panels: a few seconds of the video around a photo, drawn in the style of its panel. The frames are decoded
 * as usual and reduced by the pool. One worker draws them all in sequence, because still areas are copied from frame to
 * frame.
 */

import { buffersOf } from './protocol.ts';
import { readVideo } from './video.ts';
import { Priority } from './queue.ts';
import type { Call } from './engine.ts';
import type { Run } from './pool.ts';
import type { BitmapPatch, PixelPatch } from './protocol.ts';
import type { PageDocument } from './types.ts';
import type { Frame } from './video.ts';

/** Frames per second, and duration in seconds. */
export const LIVING = { rate: 12, seconds: 3 } as const;
/** Long side of the source frames in pixels, relative to the visible part, with limits. */
const FRAME = { shown: 960, least: 480, most: 1280 } as const;

/** The video of a photo; times in seconds. */
export type Moment = { file: File; time: number; duration: number };

/** @returns times of the frames in the video, rising, and the index of the frame closest to the photo */
export function livingTimes({ time, duration }: Pick<Moment, 'time' | 'duration'>): { times: number[]; still: number } {
  const count = LIVING.rate * LIVING.seconds;
  const step = 1 / LIVING.rate;
  const first = Math.max(0, Math.min(time - LIVING.seconds / 2, duration - LIVING.seconds));
  const times = Array.from({ length: count }, (_, i) => first + i * step).filter((at) => at < duration);
  const away = times.map((at) => Math.abs(at - time));
  return { times, still: Math.max(0, away.indexOf(Math.min(...away))) };
}

export function createLiving({ run }: { run: Run }) {
  return { drawLiving };

  /**
   * Draws a panel as a loop of `LIVING.rate` frames per second.
   * @param width of the page, in pixels
   * @returns an empty list for a still panel: the video has cuts on both sides, or its style needs a subject mask
   * @throws as `importVideo`
   */
  async function drawLiving(
    document: PageDocument,
    index: number,
    width: number,
    { file, ...moment }: Moment,
    { signal, ...call }: Call = {},
  ): Promise<BitmapPatch[]> {
    const { times, still } = livingTimes(moment);
    const shown = document.panels[index].crop?.width ?? 1;
    const longest = Math.round(Math.min(FRAME.most, Math.max(FRAME.least, FRAME.shown / shown)));
    const frames = new Map<number, PixelPatch>();
    await readVideo(
      file,
      { count: times.length, times },
      {
        signal,
        onAbout: () => {},
        onFrame: async ({ index: at, time: _, shot: __, ...frame }: Frame) => {
          const args = { frame, longest };
          const job = { op: 'smallFrame' as const, args, transfer: [frame.data.buffer], photo: file.name };
          frames.set(at, await run({ ...job, priority: Priority.VIEW, ...call, signal }));
        },
      },
    );
    const order = [...frames.keys()].sort((a, b) => a - b);
    const taken = order.map((at) => frames.get(at) as PixelPatch);
    const nearest = Math.max(0, order.filter((at) => at <= still).length - 1);
    return run({
      op: 'living',
      args: { document: JSON.stringify(document), index, width, frames: taken, still: nearest },
      transfer: buffersOf(taken),
      photo: file.name,
      priority: Priority.VIEW,
      ...call,
      signal,
    });
  }
}
