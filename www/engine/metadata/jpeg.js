// @ts-check
/** JPEG files without what they say beside their pixels. Source: ITU-T T.81, annex B; ICC.1, annex B.4. */

import { orientationOf, recordOf } from './exif.js';

const [APP0, APP1, APP2, APP14, APP15, COMMENT, END] = [0xe0, 0xe1, 0xe2, 0xee, 0xef, 0xfe, 0xd9];
const EXIF = 'Exif\0\0';
/** The segments that the pixels depend on, and how each begins. @type {Record<number, string>} */
const NEEDED = { [APP0]: 'JFIF\0', [APP2]: 'ICC_PROFILE\0', [APP14]: 'Adobe' };

/**
 * @param {Uint8Array<ArrayBuffer>} bytes of a file
 * @param {Blob} file the same
 * @returns {BlobPart[] | null} the file without comments and records, but for which side is up, and without what follows
 *   its end; null where it is not whole
 */
export function jpegParts(bytes, file) {
  /** @type {BlobPart[]} */
  const parts = [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  /** What was not yet taken begins here; a record of our own goes behind the mark of the file and its JFIF segment. */
  let from = 0;
  let orientation = 0;
  let place = -1;
  const take = (/** @type {number} */ to) => {
    if (to > from) parts.push(file.slice(from, to));
  };
  for (let at = 2; ;) {
    const start = nextMarker(bytes, at);
    if (start < 0) return null;
    const marker = bytes[start + 1];
    const application = marker >= APP0 && marker <= APP15;
    if (place < 0 && marker !== APP0) {
      take(start);
      from = start;
      place = parts.length;
    }
    if (marker === END) {
      take(start + 2);
      if (orientation > 1) parts.splice(place, 0, segment(recordOf(orientation)));
      return parts;
    }
    if (start + 4 > bytes.length) return null;
    const end = start + 2 + view.getUint16(start + 2);
    if (end > bytes.length) return null;
    const begins = (/** @type {string} */ text) => [...text].every((letter, i) => start + 4 + i < end && bytes[start + 4 + i] === letter.charCodeAt(0));
    if (marker === APP1 && orientation === 0 && begins(EXIF)) orientation = orientationOf(bytes.subarray(start + 4 + EXIF.length, end));
    if (marker === COMMENT || (application && !(NEEDED[marker] && begins(NEEDED[marker])))) {
      take(start);
      from = end;
    }
    at = end;
  }
}

/**
 * @param {Uint8Array} bytes
 * @param {number} at
 * @returns {number} where the next marker is that begins a segment or ends the file, behind stuffed zeros and restarts; -1: nowhere
 */
function nextMarker(bytes, at) {
  for (let i = bytes.indexOf(0xff, at); i >= 0 && i + 1 < bytes.length; i = bytes.indexOf(0xff, i)) {
    const next = bytes[i + 1];
    if (next === 0xff) i += 1;
    else if (next <= 0x01 || (next >= 0xd0 && next <= 0xd8)) i += 2;
    else return i;
  }
  return -1;
}

/** @param {Uint8Array<ArrayBuffer>} record @returns {Blob} in its segment */
function segment(record) {
  const length = 2 + EXIF.length + record.length;
  return new Blob([Uint8Array.of(0xff, APP1, length >> 8, length & 0xff), EXIF, record]);
}
