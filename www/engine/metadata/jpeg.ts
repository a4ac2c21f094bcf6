/** Removes metadata from JPEG files. Source: ITU-T T.81, annex B; ICC.1, annex B.4. */

import { orientationOf, recordOf } from './exif.ts';

export const [APP0, APP1, APP2, APP14, SCAN, END] = [0xe0, 0xe1, 0xe2, 0xee, 0xda, 0xd9];
/** Begins the segment of an EXIF record. */
export const EXIF = 'Exif\0\0';
/** Application segments that affect the pixels: their prefix, and their maximum length. */
const NEEDED: Record<number, { begins: string; most: number }> = {
  // Without the small picture that may follow.
  [APP0]: { begins: 'JFIF\0', most: 14 },
  [APP2]: { begins: 'ICC_PROFILE\0', most: 0xffff },
  [APP14]: { begins: 'Adobe', most: 12 },
};
/** Offsets of the thumbnail size in `APP0`. */
const SMALL_SIDES = [12, 13];

/**
 * @param bytes of a file
 * @param file the same
 * @returns its frames, tables, scans, colour profile and orientation; null if the file is incomplete
 */
export function jpegParts(bytes: Uint8Array<ArrayBuffer>, file: Blob): BlobPart[] | null {
  const parts: BlobPart[] = [file.slice(0, 2)];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let orientation = 0;
  /** A new record follows the JFIF segment. */
  let place = 1;
  for (let at = 2; ; ) {
    const start = nextMarker(bytes, at);
    if (start < 0) return null;
    const marker = bytes[start + 1];
    if (marker === END) {
      parts.push(file.slice(start, start + 2));
      if (orientation > 1) parts.splice(place, 0, exifSegment(recordOf(orientation)));
      return parts;
    }
    if (start + 4 > bytes.length) return null;
    const end = start + 2 + view.getUint16(start + 2);
    if (end > bytes.length || end < start + 4) return null;
    const begins = (text: string) =>
      [...text].every((letter, i) => start + 4 + i < end && bytes[start + 4 + i] === letter.charCodeAt(0));
    // Coded data follows the scan header.
    at = marker === SCAN ? nextMarker(bytes, end) : end;
    if (at < 0) return null;
    if (marker === APP1 && orientation === 0 && begins(EXIF))
      orientation = orientationOf(bytes.subarray(start + 4 + EXIF.length, end));
    const needed = NEEDED[marker];
    if (needed && begins(needed.begins)) {
      parts.push(shortened(bytes.slice(start, Math.min(end, start + 4 + needed.most))));
      if (marker === APP0 && place === 1) place = parts.length;
    } else if (isPicture(marker)) {
      parts.push(file.slice(start, at));
    }
  }
}

/** Frames, tables, scans and restart intervals. */
function isPicture(marker: number) {
  return (marker >= 0xc0 && marker <= 0xcf && marker !== 0xc8) || (marker >= SCAN && marker <= 0xdf);
}

/**
 * @param bytes of a segment that may have been cut; changed
 * @returns with its length, and without a small picture
 */
function shortened(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  new DataView(bytes.buffer).setUint16(2, bytes.length - 2);
  if (bytes[1] === APP0) for (const at of SMALL_SIDES) if (4 + at < bytes.length) bytes[4 + at] = 0;
  return bytes;
}

/**
 * @returns the position of the next marker that begins a segment or ends the file, after stuffed zeros and restarts; -1
 * without one
 */
function nextMarker(bytes: Uint8Array, at: number): number {
  for (let i = bytes.indexOf(0xff, at); i >= 0 && i + 1 < bytes.length; i = bytes.indexOf(0xff, i)) {
    const next = bytes[i + 1];
    if (next === 0xff) i += 1;
    else if (next <= 0x01 || (next >= 0xd0 && next <= 0xd8)) i += 2;
    else return i;
  }
  return -1;
}

/** @returns an EXIF record in its segment */
export function exifSegment(record: Uint8Array<ArrayBuffer>): Blob {
  const length = 2 + EXIF.length + record.length;
  return new Blob([Uint8Array.of(0xff, APP1, length >> 8, length & 0xff), EXIF, record]);
}
