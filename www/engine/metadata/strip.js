// @ts-check
/**
 * Photos and films without what they say beside their pixels: place, date, camera, names, comments. The pixels stay as
 * they are, bit by bit; which side is up and the colour profile stay too, as the pixels mean nothing without.
 *
 * By our own hand: what npm has either takes the orientation away with the rest, or decodes and encodes again.
 */

import { foreignKind } from '../foreign.js';
import { chunkOf, chunksOf, dataOf, isPng, pngOf, wholeChunk } from '../png-chunks.js';
import { filmParts, scrubBoxes, scrubItems } from './boxes.js';
import { orientationOf, recordOf, scrub } from './exif.js';
import { jpegParts } from './jpeg.js';
import { gifParts, webpParts } from './webp.js';

/** `clean`: false where the file is of a kind, or so broken, that nothing was taken out. @typedef {{ blob: Blob, clean: boolean }} Stripped */

/** Chunks of a PNG that change how its pixels look, and those of an animation. */
const PNG_CHUNKS = ['IHDR', 'PLTE', 'IDAT', 'IEND', 'tRNS', 'cHRM', 'gAMA', 'iCCP', 'sBIT', 'sRGB', 'cICP', 'mDCV', 'cLLI', 'bKGD', 'hIST', 'pHYs', 'sPLT', 'acTL', 'fcTL', 'fdAT'];
/** Fields of a TIFF file that tell of who, where, when and with what, as ranges of tags. */
const TIFF_TALK = [
  [0x10d, 0x110], [0x11d, 0x11d], [0x131, 0x132], [0x13b, 0x13c], [0x2bc, 0x2bc], [0x80e5, 0x80e5], [0x8298, 0x8298],
  [0x830e, 0x830e], [0x83bb, 0x83bb], [0x8480, 0x8482], [0x8568, 0x8568], [0x85d8, 0x85d8], [0x8649, 0x8649], [0x8769, 0x8769], [0x87af, 0x87b1], [0x8825, 0x8825],
  [0x9000, 0x9fff], [0xa000, 0xa4ff], [0xc4a5, 0xc4a5], [0xc614, 0xc615], [0xc62f, 0xc62f], [0xc634, 0xc634], [0xc68b, 0xc68b],
];
/** A file that is larger than this is a film; of films only some parts are read. */
const MOST_BYTES = 512 * 2 ** 20;

/** @param {Blob} file @returns {Promise<Stripped>} the same again when it is stripped again */
export async function withoutMetadata(file) {
  const parts = await partsOf(file);
  return parts ? { blob: new Blob(parts.parts, { type: file.type }), clean: parts.clean } : { blob: file, clean: false };
}

/** @param {Blob} file @returns {Promise<{ parts: BlobPart[], clean: boolean } | null>} */
async function partsOf(file) {
  const head = new Uint8Array(await file.slice(0, 256).arrayBuffer());
  const text = String.fromCharCode(...head.subarray(0, 12));
  if (await isPng(file)) return whole(await pngParts(file));
  if (text.startsWith('BM')) return whole([file]);
  if (text.slice(4, 8) === 'ftyp' && !foreignKind(head)) return filmParts(file);
  if (['moov', 'mdat', 'wide', 'skip'].includes(text.slice(4, 8))) return filmParts(file);
  if (file.size > MOST_BYTES) return null;
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (text.startsWith('\xff\xd8\xff')) return whole(jpegParts(bytes, file));
  if (text.startsWith('RIFF') && text.endsWith('WEBP')) return whole(webpParts(bytes, file));
  if (text.startsWith('GIF8')) return whole(gifParts(bytes, file));
  if (/^(II\*\0|MM\0\*)/.test(text)) return scrub(bytes, (tag) => !TIFF_TALK.some(([from, to]) => tag >= from && tag <= to)) ? whole([bytes]) : null;
  if (!foreignKind(head)) return null;
  scrubItems(bytes);
  return { parts: [bytes], clean: scrubMoving(bytes) };
}

/** @param {BlobPart[] | null} parts */
function whole(parts) {
  return parts && { parts, clean: true };
}

/** @param {Blob} file @returns {Promise<BlobPart[] | null>} null where it is not whole */
async function pngParts(file) {
  const chunks = await chunksOf(file);
  if (!chunks) return null;
  const record = chunks.find(({ type }) => type === 'eXIf');
  const data = record && await dataOf(file, record);
  const orientation = data ? orientationOf(new Uint8Array(await data.arrayBuffer())) : 1;
  const kept = chunks.filter(({ type }) => PNG_CHUNKS.includes(type)).map((chunk) => wholeChunk(file, chunk));
  const said = orientation > 1 ? [await chunkOf('eXIf', recordOf(orientation))] : [];
  return [pngOf([...kept.slice(0, 1), ...said, ...kept.slice(1)])];
}

/** The film inside of a photo that moves. @param {Uint8Array} bytes of a photo of boxes; changed @returns {boolean} whether it is clean */
function scrubMoving(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let clean = true;
  for (let at = 0; at + 8 <= bytes.length;) {
    const length = view.getUint32(at) || bytes.length - at;
    // What is longer than four gigabytes was not read at all.
    if (length < 8 || at + length > bytes.length) return clean;
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (type === 'moov' || type === 'uuid') clean = scrubBoxes(bytes.subarray(at, at + length)) && clean;
    at += length;
  }
  return clean;
}
