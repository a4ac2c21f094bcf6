/**
 * Pictures as one WebP file that plays them over and over: each is a WebP file, whose chunks are put into a frame of the
 * animation. Layout of the file after RFC 9649, section 2.7.1.
 */

import { chunk, chunksOf, fileOf } from '../engine/webp.ts';

const ANIMATION = 0x02;
const ALPHA = 0x10;
/** Not blended with the previous frame: each frame is a complete picture. No frame is cleared after it. */
const REPLACES = 0x02;
/** Chunks that hold the pixels of a picture. */
const PIXELS = ['ALPH', 'VP8 ', 'VP8L'];

type Size = { width: number; height: number };

/**
 * @param frames WebP files of that size
 * @param ms that each is seen
 * @param changes whether every frame except the first contains only its changes (`changesOf`)
 */
export function animatedWebp(
  frames: readonly Uint8Array<ArrayBuffer>[],
  { width, height }: Size,
  ms: number,
  changes = false,
): Blob {
  const head = new Uint8Array(10);
  head[0] = ANIMATION | ALPHA;
  three(head, 4, width - 1);
  three(head, 7, height - 1);
  // No background colour, and an endless loop.
  const animation = new Uint8Array(6);
  const parts = frames.map((file, i) => {
    const pixels = chunksOf(file).filter(({ name }) => PIXELS.includes(name));
    const chunks = pixels.map(({ name, data }) => chunk(name, data));
    const frame = new Uint8Array(16 + chunks.reduce((sum, part) => sum + part.length, 0));
    three(frame, 6, width - 1);
    three(frame, 9, height - 1);
    three(frame, 12, ms);
    frame[15] = changes && i > 0 ? 0 : REPLACES;
    let at = 16;
    for (const part of chunks) {
      frame.set(part, at);
      at += part.length;
    }
    return chunk('ANMF', frame);
  });
  return fileOf([chunk('VP8X', head), chunk('ANIM', animation), ...parts]);
}

/** @returns the pixels of a picture (RGBA) that differ from the one before; all others are clear, and those before are seen */
export function changesOf(
  picture: Uint8ClampedArray<ArrayBuffer>,
  before: Uint8ClampedArray<ArrayBuffer>,
): Uint8ClampedArray<ArrayBuffer> {
  const [now, then] = [picture, before].map(({ buffer }) => new Uint32Array(buffer));
  const changes = new Uint32Array(now.length);
  for (let i = 0; i < now.length; i += 1) if (now[i] !== then[i]) changes[i] = now[i];
  return new Uint8ClampedArray(changes.buffer);
}

/** Writes a number of three bytes, the lowest first. */
function three(into: Uint8Array, at: number, value: number) {
  for (let i = 0; i < 3; i += 1) into[at + i] = (value >> (8 * i)) & 0xff;
}
