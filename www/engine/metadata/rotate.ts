/**
 * Rotates and flips photos without decoding them: the file gets another EXIF orientation. Pixels and other metadata
 * stay. Source: CIPA DC-008 (Exif 2.32), section 4.6.5; ITU-T T.81, annex B; PNG Specification (Third Edition),
 * section 11.3.4.
 */

import { chunkOf, chunksOf, dataOf, isPng, pngOf, wholeChunk } from '../png-chunks.ts';
import { orientationOf, recordOf, withOrientation } from './exif.ts';
import { APP0, APP1, EXIF, SCAN, exifSegment } from './jpeg.ts';

/** `right`: by 90 degrees, clockwise. `flip`: mirrored, left and right. */
export type Rotation = 'right' | 'flip';

/** The orientation after a rotation, by the orientation before, from 1. */
const AFTER = { right: [6, 7, 8, 5, 2, 3, 4, 1], flip: [2, 1, 4, 3, 6, 5, 8, 7] };

/** Maximum size in bytes of a record in a JPEG file. */
const MOST_RECORD = 0xffff - 2 - EXIF.length;
/** Size in bytes of the part of a JPEG file that contains the EXIF record. */
const HEAD = 2 ** 20;

/** @returns null if the format of the file has no orientation, or if the file is damaged */
export async function rotatedFile(file: Blob, rotation: Rotation): Promise<Blob | null> {
  if (await isPng(file)) return rotatedPng(file, rotation);
  const head = new Uint8Array(await file.slice(0, HEAD).arrayBuffer());
  const parts = head[0] === 0xff && head[1] === 0xd8 ? jpegParts(head, file, rotation) : null;
  return parts && new Blob(parts, { type: 'image/jpeg' });
}

function rotatedRecord(record: Uint8Array | null, rotation: Rotation): Uint8Array<ArrayBuffer> {
  const orientation = AFTER[rotation][orientationOf(record ?? new Uint8Array()) - 1];
  return (record && withOrientation(record, orientation)) ?? recordOf(orientation);
}

async function rotatedPng(file: Blob, rotation: Rotation): Promise<Blob | null> {
  const chunks = await chunksOf(file);
  if (!chunks) return null;
  const known = chunks.find(({ type }) => type === 'eXIf');
  const data = known && (await dataOf(file, known));
  const record = rotatedRecord(data ? new Uint8Array(await data.arrayBuffer()) : null, rotation);
  const [header, ...others] = chunks.filter(({ type }) => type !== 'eXIf').map((chunk) => wholeChunk(file, chunk));
  return pngOf([header, await chunkOf('eXIf', record), ...others]);
}

/** @param head the first bytes of the file */
function jpegParts(head: Uint8Array<ArrayBuffer>, file: Blob, rotation: Rotation): BlobPart[] | null {
  const view = new DataView(head.buffer);
  /** A new record follows the JFIF segment. */
  let place = 2;
  for (let at = 2; at + 4 <= head.length; ) {
    const marker = head[at + 1];
    if (head[at] !== 0xff) return null;
    const end = at + 2 + view.getUint16(at + 2);
    if (marker === APP1 && begins(head, at + 4)) {
      if (end > head.length) return null;
      const record = rotatedRecord(head.subarray(at + 4 + EXIF.length, end), rotation);
      return [file.slice(0, at), segment(record), file.slice(end)];
    }
    if (marker === SCAN) break;
    if (marker === APP0) place = end;
    at = end;
  }
  return [file.slice(0, place), segment(rotatedRecord(null, rotation)), file.slice(place)];
}

function begins(head: Uint8Array, at: number) {
  return [...EXIF].every((letter, i) => head[at + i] === letter.charCodeAt(0));
}

/** @returns in its segment; a record that is too long is reduced to its orientation */
function segment(record: Uint8Array<ArrayBuffer>): Blob {
  return exifSegment(record.length > MOST_RECORD ? recordOf(orientationOf(record)) : record);
}
