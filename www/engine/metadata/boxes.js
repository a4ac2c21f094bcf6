// @ts-check
/**
 * Files of boxes (HEIC, AVIF, MP4, QuickTime) without what they say beside their pixels. Positions in such a file are
 * counted from its beginning, so nothing is cut out: what has to go is blanked where it stands.
 * Sources: ISO/IEC 14496-12; QuickTime File Format, user data and metadata.
 */

import { isOrientation, scrub } from './exif.js';

/** Boxes of words and numbers about a film: place, camera, date, author. */
const TALK = ['udta', 'meta', 'uuid'];
const INSIDE = ['moov', 'trak', 'mdia'];
/** Boxes that begin with when they were made and changed. */
const DATED = ['mvhd', 'tkhd', 'mdhd'];
/** What a track is that is no picture and no sound: the places of a journey, for example. */
const TOLD = ['meta', 'camm', 'gpmd'];
const HANDLER = 'hdlr';
/** No part of a film that is read as a whole is larger. */
const MOST_BYTES = 256 * 2 ** 20;

/**
 * @param {Blob} file a film
 * @returns {Promise<{ parts: BlobPart[], clean: boolean } | null>} `clean`: false where a track of it tells more, which
 *   stays; null where it is not whole
 */
export async function filmParts(file) {
  /** @type {BlobPart[]} */
  const parts = [];
  let clean = true;
  for (let at = 0; at < file.size;) {
    const head = new DataView(await file.slice(at, at + 16).arrayBuffer());
    const box = head.byteLength < 8 ? null : boxAt(head, 0, file.size - at);
    if (!box) return null;
    const part = file.slice(at, at + box.length);
    if (box.type === 'moov' || TALK.includes(box.type)) {
      if (box.length > MOST_BYTES) return null;
      const bytes = new Uint8Array(await part.arrayBuffer());
      clean = scrubBoxes(bytes) && clean;
      parts.push(bytes);
    } else parts.push(part);
    at += box.length;
  }
  return { parts, clean };
}

/**
 * @param {DataView} view
 * @param {number} at
 * @param {number} room bytes until the end of what it is in
 * @returns {{ type: string, head: number, length: number } | null}
 */
function boxAt(view, at, room) {
  const short = view.getUint32(at);
  const type = String.fromCharCode(...[4, 5, 6, 7].map((i) => view.getUint8(at + i)));
  if (short === 1 && at + 16 > view.byteLength) return null;
  const [head, length] = short === 1 ? [16, Number(view.getBigUint64(at + 8))] : [8, short === 0 ? room : short];
  return length < head || length > room ? null : { type, head, length };
}

/**
 * @param {Uint8Array} bytes of boxes, one after the other; changed
 * @returns {boolean} whether nothing is told any more
 */
export function scrubBoxes(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let clean = true;
  for (let at = 0; at + 8 <= bytes.length;) {
    const box = boxAt(view, at, bytes.length - at);
    if (!box) return false;
    const [start, end] = [at + box.head, at + box.length];
    if (TALK.includes(box.type)) {
      bytes.set([0x66, 0x72, 0x65, 0x65], at + 4); // A box called `free` is passed over by every reader.
      bytes.fill(0, start, end);
    } else if (DATED.includes(box.type)) {
      bytes.fill(0, start + 4, Math.min(end, start + (bytes[start] === 1 ? 20 : 12)));
    } else if (box.type === HANDLER) {
      clean = clean && !TOLD.includes(String.fromCharCode(...bytes.subarray(start + 8, start + 12)));
    } else if (INSIDE.includes(box.type)) {
      clean = scrubBoxes(bytes.subarray(start, end)) && clean;
    }
    at = end;
  }
  return clean;
}

/** How XMP begins and ends. */
const XMP = [['<?xpacket begin', '<?xpacket end'], ['<x:xmpmeta', '</x:xmpmeta>']];

/**
 * A photo: its records are items somewhere among the pixels.
 * @param {Uint8Array<ArrayBuffer>} bytes of a HEIC or AVIF file; changed
 */
export function scrubItems(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (const [mark, little] of /** @type {const} */ ([[0x49, true], [0x4d, false]])) {
    for (let at = bytes.indexOf(mark); at >= 0 && at + 8 <= bytes.length; at = bytes.indexOf(mark, at + 1)) {
      if (view.getUint32(at) === (little ? 0x49492a00 : 0x4d4d002a) && view.getUint32(at + 4, little) === 8) scrub(bytes.subarray(at), isOrientation);
    }
  }
  for (const [begin, end] of XMP) {
    for (let at = find(bytes, begin, 0); at >= 0; at = find(bytes, begin, at + 1)) {
      const stop = find(bytes, end, at);
      if (stop >= 0) bytes.fill(0x20, at, stop + end.length);
    }
  }
}

/** @param {Uint8Array} bytes @param {string} text @param {number} from @returns {number} where the text is, -1: nowhere */
function find(bytes, text, from) {
  const first = text.charCodeAt(0);
  for (let at = bytes.indexOf(first, from); at >= 0; at = bytes.indexOf(first, at + 1)) {
    let same = 1;
    while (same < text.length && bytes[at + same] === text.charCodeAt(same)) same += 1;
    if (same === text.length) return at;
  }
  return -1;
}
