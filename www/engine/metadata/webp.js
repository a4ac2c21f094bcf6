// @ts-check
/** WebP and GIF files without what they say beside their pixels. Sources: RFC 9649; GIF89a Specification. */

import { orientationOf, recordOf } from './exif.js';

const NEEDED = ['VP8X', 'VP8 ', 'VP8L', 'ALPH', 'ANIM', 'ANMF', 'ICCP'];
/** Bits of the first byte of `VP8X`: the file has EXIF, it has XMP. */
const [HAS_EXIF, HAS_XMP] = [8, 4];

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {Blob} file the same
 * @returns {BlobPart[] | null} null where it is not whole
 */
export function webpParts(bytes, file) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = (/** @type {number} */ at) => String.fromCharCode(...bytes.subarray(at, at + 4));
  const end = 8 + view.getUint32(4, true);
  if (end > bytes.length) return null;
  /** @type {Blob[]} */
  const parts = [];
  let flags = -1;
  let orientation = 1;
  for (let at = 12; at < end;) {
    if (at + 8 > end) return null;
    const [type, length] = [text(at), view.getUint32(at + 4, true)];
    const next = at + 8 + length + (length % 2);
    if (at + 8 + length > end) return null;
    if (type === 'VP8X' && at === 12 && length === 10) flags = parts.length;
    // The mark of JPEG before the record is one that some writers put here too.
    if (type === 'EXIF') orientation = orientationOf(bytes.subarray(at + 8 + (text(at + 8) === 'Exif' ? 6 : 0), at + 8 + length));
    if (NEEDED.includes(type)) parts.push(file.slice(at, Math.min(next, end)));
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

const [EXTENSION, PICTURE, END] = [0x21, 0x2c, 0x3b];
const [COMMENT, APPLICATION] = [0xfe, 0xff];
/** How often it plays, and its colours. */
const APPLICATIONS = ['NETSCAPE2.0', 'ANIMEXTS1.0', 'ICCRGBG1012'];

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {Blob} file the same
 * @returns {BlobPart[] | null} null where it is not whole
 */
export function gifParts(bytes, file) {
  const table = (/** @type {number} */ flags) => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  /** @type {BlobPart[]} */
  const parts = [];
  let from = 0;
  for (let at = 13 + table(bytes[10]); at < bytes.length;) {
    const [start, kind, label] = [at, bytes[at], bytes[at + 1]];
    if (kind === END) return [...parts, file.slice(from, at + 1)];
    if (kind === PICTURE) at += 11 + table(bytes[at + 9]);
    else if (kind === EXTENSION) at += 2;
    else return null;
    const application = String.fromCharCode(...bytes.subarray(at + 1, at + 12));
    while (at < bytes.length && bytes[at] !== 0) at += 1 + bytes[at];
    at += 1;
    if (kind === EXTENSION && (label === COMMENT || (label === APPLICATION && !APPLICATIONS.includes(application)))) {
      parts.push(file.slice(from, start));
      from = at;
    }
  }
  return null;
}
