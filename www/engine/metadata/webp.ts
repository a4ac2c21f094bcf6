/** Removes metadata from WebP files. Source: RFC 9649. */

import { orientationOf, recordOf } from './exif.ts';

const NEEDED = ['VP8X', 'VP8 ', 'VP8L', 'ALPH', 'ANIM', 'ANMF', 'ICCP'];
/** Animation frame: position and duration, then image chunks. */
const FRAME = 'ANMF';
const FRAME_HEAD = 16;
const NEEDED_IN_FRAME = ['VP8 ', 'VP8L', 'ALPH'];
/** Bits of the first byte of `VP8X`: the file has EXIF, it has XMP. */
const [HAS_EXIF, HAS_XMP] = [8, 4];

/**
 * @param file the same
 * @returns null if the file is incomplete
 */
export function webpParts(bytes: Uint8Array<ArrayBuffer>, file: Blob): BlobPart[] | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = (at: number) => String.fromCharCode(...bytes.subarray(at, at + 4));
  const end = 8 + view.getUint32(4, true);
  if (end > bytes.length) return null;
  const parts: Blob[] = [];
  let flags = -1;
  let orientation = 1;
  for (let at = 12; at < end; ) {
    const chunk = chunkAt(view, at, end);
    if (!chunk) return null;
    const { type, length, next } = chunk;
    if (type === 'VP8X' && at === 12 && length === 10) flags = parts.length;
    // Some writers add the JPEG prefix to the record here as well.
    if (type === 'EXIF')
      orientation = orientationOf(bytes.subarray(at + 8 + (text(at + 8) === 'Exif' ? 6 : 0), at + 8 + length));
    const part = type === FRAME ? frame(view, at, file, length) : whole(file, at, length);
    if (!part) return null;
    if (NEEDED.includes(type)) parts.push(part);
    at = next;
  }
  const kept = orientation > 1 ? HAS_EXIF : 0;
  if (flags >= 0) {
    const head = bytes.slice(12, 12 + 18);
    head[8] = (head[8] & ~(HAS_EXIF | HAS_XMP)) | kept;
    parts[flags] = new Blob([head]);
    const record = recordOf(orientation);
    if (kept) parts.push(new Blob(['EXIF', Uint8Array.of(record.length, 0, 0, 0), record]));
  }
  const size = new DataView(new ArrayBuffer(4));
  size.setUint32(0, 4 + new Blob(parts).size, true);
  return ['RIFF', size, 'WEBP', ...parts];
}

/**
 * @param end end of the parent
 * @returns null if it is truncated
 */
function chunkAt(view: DataView, at: number, end: number): { type: string; length: number; next: number } | null {
  if (at + 8 > end) return null;
  const type = String.fromCharCode(...[0, 1, 2, 3].map((i) => view.getUint8(at + i)));
  const length = view.getUint32(at + 4, true);
  return at + 8 + length > end ? null : { type, length, next: at + 8 + length + (length % 2) };
}

/** @returns a chunk, with a zero padding byte if necessary */
function whole(file: Blob, at: number, length: number): Blob {
  return new Blob([file.slice(at, at + 8 + length), new Uint8Array(length % 2)]);
}

/** @returns an animation frame with only image chunks */
function frame(view: DataView, at: number, file: Blob, length: number): Blob | null {
  const end = at + 8 + length;
  const parts: Blob[] = [];
  for (let inner = at + 8 + FRAME_HEAD; inner < end; ) {
    const chunk = chunkAt(view, inner, end);
    if (!chunk) return null;
    if (NEEDED_IN_FRAME.includes(chunk.type)) parts.push(whole(file, inner, chunk.length));
    inner = chunk.next;
  }
  const body = new Blob([file.slice(at + 8, at + 8 + FRAME_HEAD), ...parts]);
  const size = new DataView(new ArrayBuffer(4));
  size.setUint32(0, body.size, true);
  return new Blob([FRAME, size, body]);
}
