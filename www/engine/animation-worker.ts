/**
 * Extracts frames of one animated GIF or WebP file and ends. It is a separate worker, so that it can be stopped at any
 * moment. The protocol is in `frame-sender.ts`. The worker decodes frames itself, because Safari returns only the first
 * frame.
 */

import { endsOf } from './animation-times.ts';
import { mayGoOn, sendFrame, serveFrames } from './frame-sender.ts';
import { failure } from './protocol.ts';
import { decoders } from './rare.ts';
import { runs, sampleTimes } from './sample-times.ts';
import type { Animation } from '../pkg-decoders/inkpanel.js';
import type { FileWish } from './frame-sender.ts';

/** Maximum size in bytes of cached frames before the urgent ones. Other frames are decoded again. */
const MOST_KEPT = 64 * 2 ** 20;

type Picture = { width: number; height: number; data: Uint8Array<ArrayBuffer> };

serveFrames(read);

async function read({ file, count, start, end, leading, times: told }: FileWish) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const ends = endsOf(bytes);
  const duration = ends[ends.length - 1] ?? 0;
  const { Animation } = await decoders();
  postMessage({ about: { duration } });
  const times = told ?? sampleTimes({ first: 0, duration, count, start, end });
  /** The picture of each time. A slow animation may show one frame at two of the times. It is returned once. */
  const shown = times.map((time) => {
    const later = ends.findIndex((till) => time < till);
    return later < 0 ? ends.length - 1 : later;
  });
  const left = new Set(shown);
  const kept = new Map<number, Picture>();
  let room = MOST_KEPT;

  for (const run of runs(times.length, leading)) {
    // Each picture is laid on those before it, so that a run begins with the first.
    const animation = new Animation(bytes);
    let number = -1;
    for (const index of run) {
      const target = shown[index];
      if (!left.has(target)) continue;
      let picture = kept.get(target) ?? null;
      while (!picture && number < target && advanced(animation)) {
        number += 1;
        if (number === target) picture = taken(animation);
        else if (left.has(number) && !kept.has(number) && room > 0) {
          const passed = taken(animation);
          room -= passed.data.length;
          kept.set(number, passed);
        }
      }
      // A truncated file ends with its last complete frame.
      if (!picture) break;
      left.delete(target);
      kept.delete(target);
      await mayGoOn();
      const { width, height, data } = picture;
      sendFrame({
        index,
        time: times[index],
        width,
        height,
        squareWidth: width,
        squareHeight: height,
        rotation: 0,
        data,
      });
    }
    animation.free();
  }
  if (left.size === new Set(shown).size) throw failure('damaged', 'The animation is damaged or truncated.');
}

/** Returns whether there is another complete picture. */
function advanced(animation: Animation): boolean {
  try {
    return animation.advance();
  } catch {
    return false;
  }
}

function taken(animation: Animation): Picture {
  const picture = animation.picture();
  const { width, height } = picture;
  const data = picture.take() as Uint8Array<ArrayBuffer>;
  picture.free();
  return { width, height, data };
}
