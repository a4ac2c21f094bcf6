/**
 * Takes pictures out of one animated GIF or WebP file and ends with it. A worker of its own, so that it can be stopped
 * at any moment; the protocol is that of `frame-sender.ts`.
 */

import { endsOf } from './animation-times.ts';
import { rgbaOf } from './frame-pixels.ts';
import { mayGoOn, sendFrame, serveFrames } from './frame-sender.ts';
import { failure } from './protocol.ts';
import { runs, sampleTimes } from './sample-times.ts';
import type { FileWish } from './frame-sender.ts';

serveFrames(read);

async function read({ file, count, start, end, leading }: FileWish) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const ends = endsOf(bytes);
  const duration = ends[ends.length - 1] ?? 0;
  const decoder = new ImageDecoder({ type: bytes[0] === 0x47 ? 'image/gif' : 'image/webp', data: bytes });
  postMessage({ about: { duration } });
  const times = sampleTimes({ first: 0, duration, count, start, end });
  const sent = new Set();
  for (const run of runs(times.length, leading)) {
    for (const index of run) {
      const later = ends.findIndex((till) => times[index] < till);
      const frameIndex = later < 0 ? ends.length - 1 : later;
      // A slow animation may show one picture at two of the times.
      if (sent.has(frameIndex)) continue;
      const picture = await decoder.decode({ frameIndex }).then(
        ({ image }) => image,
        () => null,
      );
      // A file that breaks off ends with its last whole picture.
      if (!picture) break;
      sent.add(frameIndex);
      await mayGoOn();
      const { width, height, data } = await rgbaOf(picture);
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
  }
  if (sent.size === 0) throw failure('damaged', 'The animation is damaged or cut short.');
}
