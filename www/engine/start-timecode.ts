/**
 * The timecode of the first frame of an MP4 or QuickTime file: the first sample of its timecode track is the number of
 * frames since midnight. Source: QuickTime File Format, "Timecode Media".
 */

import { boxAt, typeAt } from './metadata/boxes.ts';
import type { StartTimecode } from './types.ts';

/** Maximum number of boxes that are read. */
const MOST_BOXES = 5000;
/** Bytes that are read of a box. */
const MOST_BYTES = 1 << 16;
/** Flags of a timecode: frame numbers are dropped; it is a counter, and not a time of day. */
const DROP = 1;
const COUNTER = 8;
const MAX_FPS = 120;

/** Start and end of the content of a box. */
type Content = { inner: number; end: number };

/** @returns null for a file without a timecode, and for any other file */
export async function startTimecode(file: Blob): Promise<StartTimecode | null> {
  let left = MOST_BOXES;
  try {
    const whole = { inner: 0, end: file.size };
    for await (const track of boxesIn(whole, ['moov', 'trak'])) {
      const found = await timecodeOf(track);
      if (found) return found;
    }
  } catch {
    // A file that cannot be read is reported when its frames are read.
  }
  return null;

  async function timecodeOf(track: Content): Promise<StartTimecode | null> {
    const handler = await read(track, 'mdia', 'hdlr');
    if (!handler || typeAt(handler, 8) !== 'tmcd') return null;
    const description = await read(track, 'mdia', 'minf', 'stbl', 'stsd');
    const short = await read(track, 'mdia', 'minf', 'stbl', 'stco');
    const long = short ? null : await read(track, 'mdia', 'minf', 'stbl', 'co64');
    const place = short ? short.getUint32(8) : Number(long?.getBigUint64(8));
    if (!description || typeAt(description, 12) !== 'tmcd') return null;
    const sample = new DataView(await file.slice(place, place + 4).arrayBuffer());
    return startOf(sample.getUint32(0), description);
  }

  /** @param path types of nested boxes @returns the content of the first match */
  async function read(within: Content, ...path: string[]): Promise<DataView | null> {
    for await (const { inner, end } of boxesIn(within, path))
      return new DataView(await file.slice(inner, Math.min(end, inner + MOST_BYTES)).arrayBuffer());
    return null;
  }

  async function* boxesIn({ inner, end }: Content, [type, ...rest]: readonly string[]): AsyncGenerator<Content> {
    for (let at = inner; at < end && left > 0; left -= 1) {
      const head = new DataView(await file.slice(at, Math.min(at + 16, end)).arrayBuffer());
      const box = boxAt(head, 0, end - at);
      if (!box) return;
      const content = { inner: at + box.inner, end: at + box.end };
      if (box.type === type && rest.length === 0) yield content;
      else if (box.type === type) yield* boxesIn(content, rest);
      at += box.end;
    }
  }
}

/** @param description of the track: version, count, length and type come first, and what every description has */
function startOf(frame: number, description: DataView): StartTimecode | null {
  const flags = description.getUint32(28);
  const fps = description.getUint8(40) || Math.round(description.getUint32(32) / description.getUint32(36));
  const drop = (flags & DROP) !== 0;
  const valid = fps >= 1 && fps <= MAX_FPS && !(flags & COUNTER) && (!drop || fps % 30 === 0);
  return valid && frame < framesOfDay(fps, drop) ? { frame, fps, drop } : null;
}

/** Drop-frame timecode leaves out two numbers of thirty in each minute, except in every tenth. */
function framesOfDay(fps: number, drop: boolean) {
  const minutes = 24 * 60;
  return minutes * 60 * fps - (drop ? (fps / 15) * (minutes - minutes / 10) : 0);
}
