/**
 * Removes metadata from BMP files: in reserved fields, in gaps, at the ends of rows, after the end. Sources:
 * Microsoft's BITMAPINFOHEADER, BITMAPV4HEADER and BITMAPV5HEADER; OS/2 Presentation Manager for OS22XBITMAPHEADER.
 */

import { blankAround } from './ranges.ts';
import type { Range } from './ranges.ts';

/** Bytes of the head of the file. */
const FILE_HEAD = 14;
/** Heads of the picture, by their length. */
const [CORE, INFO, OS2, V4, V5] = [12, 40, 64, 108, 124];
const HEADS = [CORE, INFO, 52, 56, OS2, V4, V5];
/** How pixels are packed. */
const [PLAIN, RLE8, RLE4, MASKS, ALPHA_MASKS] = [0, 1, 2, 3, 6];
/** Kinds of colour profiles: embedded, linked, and none, with their codes. */
const [EMBEDDED, LINKED, SRGB] = [0x4d424544, 0x4c494e4b, 0x73524742];

/**
 * @param bytes of a file; changed
 * @returns null if the file is incomplete or contains another format
 */
export function bmpParts(bytes: Uint8Array<ArrayBuffer>): BlobPart[] | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const head = bytes.length < FILE_HEAD + CORE ? 0 : view.getUint32(FILE_HEAD, true);
  if (!HEADS.includes(head) || FILE_HEAD + head > bytes.length) return null;
  const long = head > CORE;
  const side = (at: number) =>
    long ? Math.abs(view.getInt32(FILE_HEAD + 4 + 4 * at, true)) : view.getUint16(FILE_HEAD + 4 + 2 * at, true);
  const [width, height, bits] = [side(0), side(1), view.getUint16(FILE_HEAD + (long ? 14 : 10), true)];
  const [packing, told, used] = long
    ? [16, 20, 32].map((field) => view.getUint32(FILE_HEAD + field, true))
    : [PLAIN, 0, 0];
  const start = view.getUint32(10, true);

  const masks = head === INFO && packing === MASKS ? 12 : head === INFO && packing === ALPHA_MASKS ? 16 : 0;
  const colours = bits > 8 ? 0 : Math.min(used || 2 ** bits, 2 ** bits) * (long ? 4 : 3);
  const behindHead = FILE_HEAD + head + masks + colours;
  const length =
    packing === RLE8 || packing === RLE4
      ? lengthOfRuns(bytes, start, packing, told)
      : [PLAIN, MASKS, ALPHA_MASKS].includes(packing)
        ? rowOf(width, bits) * height
        : 0;
  if (start < behindHead || length === 0 || start + length > bytes.length) return null;

  if (packing !== RLE8 && packing !== RLE4)
    blankEnds(bytes, start, height, { row: rowOf(width, bits), used: width * bits });
  const kept: Range[] = [
    [0, behindHead],
    [start, start + length],
  ];
  let end = start + length;
  if (head === V5) {
    const [from, size] = [112, 116].map((field) => view.getUint32(FILE_HEAD + field, true));
    const profile = [FILE_HEAD + from, FILE_HEAD + from + size] as const;
    if (view.getUint32(FILE_HEAD + 56, true) === EMBEDDED && profile[0] >= behindHead && profile[1] <= bytes.length) {
      kept.push(profile);
      end = Math.max(end, profile[1]);
    } else {
      // A profile that is elsewhere is the name of a file.
      if ([EMBEDDED, LINKED].includes(view.getUint32(FILE_HEAD + 56, true))) view.setUint32(FILE_HEAD + 56, SRGB, true);
      bytes.fill(0, FILE_HEAD + 112, FILE_HEAD + 120);
    }
    bytes.fill(0, FILE_HEAD + 120, FILE_HEAD + V5);
  }
  if (head === OS2) bytes.fill(0, FILE_HEAD + INFO, FILE_HEAD + OS2);
  bytes.fill(0, 6, 10);
  if (long) for (let at = behindHead - colours + 3; at < behindHead; at += 4) bytes[at] = 0;
  view.setUint32(2, end, true);
  const whole = bytes.subarray(0, end);
  blankAround(whole, kept);
  return [whole];
}

/** @returns bytes of a row, padded to 32-bit words */
function rowOf(width: number, bits: number): number {
  return 4 * Math.ceil((width * bits) / 32);
}

/**
 * Blanks the unused bits of each row.
 * @param bytes are changed
 * @param lengths bytes of a row, and bits of it that are pixels
 */
function blankEnds(bytes: Uint8Array, start: number, rows: number, { row, used }: { row: number; used: number }) {
  const whole = used >> 3;
  if (whole === row) return;
  for (let at = start; at < start + rows * row; at += row) {
    if (used % 8) bytes[at + whole] &= 0xff00 >> (used % 8);
    bytes.fill(0, at + Math.ceil(used / 8), at + row);
  }
}

/**
 * @param told length in the header of the file
 * @returns bytes of the runs to their end, or the stated length without an end mark; 0 if they are truncated
 */
function lengthOfRuns(bytes: Uint8Array, start: number, packing: number, told: number): number {
  for (let at = start; at + 1 < bytes.length; ) {
    const [count, value] = [bytes[at], bytes[at + 1]];
    at += 2;
    if (count > 0) continue;
    // End of the picture, a move, or single pixels, padded to 16-bit words.
    if (value === 1) return at - start;
    if (value === 2) at += 2;
    else if (value > 2) at += 2 * Math.ceil((packing === RLE8 ? value : value / 2) / 2);
  }
  return start + told <= bytes.length ? told : 0;
}
