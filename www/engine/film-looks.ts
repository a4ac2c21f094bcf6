/**
 * Samples a video for shot detection. Short videos are decoded completely. For long videos, some key frames come first,
 * for the first page. Then follow all key frames and the frames between them, starting where most changes happen, until
 * the time is used up.
 */

import { EncodedPacketSink, VideoSampleSink } from 'mediabunny';
import { detach } from './blobs.ts';
import { rgbaOf } from './frame-pixels.ts';
import type { InputVideoTrack, VideoSample } from 'mediabunny';
import type { Looking } from '../pkg-films/inkpanel.js';

/** Maximum number of frames of a video that is decoded completely. */
const SHORT = 1500;
/** For long videos: number of key frames in the first pass, and in total. */
const GLANCE = 24;
const MOST_KEYS = 2000;
/** Maximum milliseconds for sampling frames between key frames. */
const BETWEEN = 18_000;
/** Time limit for short videos in milliseconds. */
const WHOLE = 30_000;
/** Seconds after each key frame that are sampled first, and samples per second in the rest of each gap. */
const AFTER = 0.6;
const OFTEN = 10;

/** A part of the video to sample, in seconds. */
export type Stretch = { from: number; to: number };

export function createLooks(track: InputVideoTrack, looking: Looking, { from, to }: Stretch) {
  const sink = new VideoSampleSink(track);
  const packets = new EncodedPacketSink(track);
  let buffer = new Uint8Array(0);

  return { isShort, glance, whole, keys, between };

  async function isShort(): Promise<boolean> {
    const { averagePacketRate } = await track.computePacketStats(60);
    return (to - from) * averagePacketRate <= SHORT;
  }

  /** Samples some key frames of the whole video. */
  async function glance() {
    const found = new Set<number>();
    for (let i = 0; i < GLANCE; i += 1) {
      const time = from + ((i + 0.5) / GLANCE) * (to - from);
      const packet = await packets.getKeyPacket(time, { metadataOnly: true });
      if (packet && packet.timestamp >= from) found.add(packet.timestamp);
    }
    await at([...found]);
  }

  /** @param tell progress, 0 to 1 */
  async function whole(tell: (part: number) => void) {
    await during(from, to, { every: 0, until: performance.now() + WHOLE, tell });
  }

  /** Looks at the key frames. @returns their times, rising */
  async function keys(tell: (part: number) => void): Promise<number[]> {
    const times: number[] = [];
    let packet = await packets.getKeyPacket(from, { metadataOnly: true });
    packet ??= await packets.getFirstKeyPacket({ metadataOnly: true });
    while (packet && packet.timestamp < to) {
      times.push(packet.timestamp);
      packet = await packets.getNextKeyPacket(packet, { metadataOnly: true });
    }
    const every = Math.max(1, times.length / MOST_KEYS);
    const some = Array.from({ length: Math.ceil(times.length / every) }, (_, i) => times[Math.floor(i * every)]);
    await at(some, tell);
    return some;
  }

  /** Looks between key frames until time is over. @param times of these */
  async function between(times: readonly number[], tell: (part: number) => void) {
    const begin = performance.now();
    const until = begin + BETWEEN;
    const told = () => tell(Math.min(1, (performance.now() - begin) / BETWEEN));
    const gaps = times.map((start, i) => {
      const end = times[i + 1] ?? to;
      return { start, end, length: end - start, change: Math.min(30, looking.change(start)) };
    });
    // A shot usually begins with a key frame, which may still contain blur from the shot before.
    for (const { start, end } of gaps) {
      if (performance.now() > begin + BETWEEN / 2) break;
      await during(start, Math.min(end, start + AFTER), { every: 0.25, until, tell: told });
    }
    gaps.sort((a, b) => b.length * (3 + b.change) - a.length * (3 + a.change));
    for (const { start, end, length } of gaps) {
      if (performance.now() > until) break;
      if (length > AFTER) await during(start, end, { every: 1 / OFTEN, until, tell: told });
    }
  }

  async function at(times: readonly number[], tell: (part: number) => void = () => {}) {
    let done = 0;
    for await (const sample of sink.samplesAtTimestamps(times)) {
      done += 1;
      if (sample) await look(sample);
      if (done % 8 === 0) tell(done / times.length);
    }
  }

  /** @param how `every`: seconds between two samples; `until`: time limit, in milliseconds of this worker's clock */
  async function during(
    start: number,
    end: number,
    { every, until, tell }: { every: number; until: number; tell: (part: number) => void },
  ) {
    let next = -Infinity;
    let count = 0;
    for await (const sample of sink.samples(start, end)) {
      if (performance.now() > until) {
        sample.close();
        break;
      }
      if (sample.timestamp < next || sample.timestamp < from) {
        sample.close();
        continue;
      }
      next = sample.timestamp + every - 1e-3;
      const { timestamp } = sample;
      await look(sample);
      count += 1;
      if (count % 8 === 0) tell((timestamp - start) / (end - start));
    }
  }

  /** @param sample which is closed */
  async function look(sample: VideoSample) {
    const frame = sample.toVideoFrame();
    const { timestamp } = sample;
    sample.close();
    const { format } = frame;
    if (format !== 'I420' && format !== 'NV12') {
      const { width, height, data } = await rgbaOf(frame);
      looking.look(timestamp, 'RGBA', width, height, data, new Uint32Array());
      detach(data);
      return;
    }
    try {
      const { width, height } = frame.visibleRect as DOMRectReadOnly;
      const size = frame.allocationSize();
      if (buffer.length < size) buffer = new Uint8Array(size);
      const planes = await frame.copyTo(buffer);
      const places = Uint32Array.from(planes.flatMap(({ offset, stride }) => [offset, stride]));
      looking.look(timestamp, format, width, height, buffer.subarray(0, size), places);
    } finally {
      frame.close();
    }
  }
}
