/**
 * Removes metadata from photos and videos: place, date, camera, names, comments. The pixels do not change. Orientation
 * and colour profile stay, because pixels depend on them. An allowlist per format defines the preserved data.
 * Everything else is removed: unknown fields, data in gaps, data after the end.
 *
 * This is own code, because npm packages remove the orientation as well, or decode and encode the image again.
 */

import { foreignKind } from '../foreign.ts';
import { chunkOf, chunksOf, dataOf, isPng, pngOf, wholeChunk } from '../png-chunks.ts';
import { bmpParts } from './bmp.ts';
import { filmParts } from './boxes.ts';
import { orientationOf, recordOf } from './exif.ts';
import { gifParts } from './gif.ts';
import { itemParts } from './items.ts';
import { jpegParts } from './jpeg.ts';
import { tiffParts } from './tiff.ts';
import { webpParts } from './webp.ts';

/** `clean`: false if the file still contains metadata, because its format is unknown or it is damaged. */
export type Stripped = { blob: Blob; clean: boolean };

/** PNG chunks that change the look of pixels, and chunks of animations. Other chunks are removed. */
const PNG_CHUNKS = [
  'IHDR',
  'PLTE',
  'IDAT',
  'IEND',
  'tRNS',
  'cHRM',
  'gAMA',
  'iCCP',
  'sBIT',
  'sRGB',
  'cICP',
  'mDCV',
  'cLLI',
  'bKGD',
  'pHYs',
  'acTL',
  'fcTL',
  'fdAT',
];
/** Minimum size of a file that counts as a video. Videos are only read in part. */
const MOST_BYTES = 512 * 2 ** 20;

/** @returns the same again when it is stripped again */
export async function withoutMetadata(file: Blob): Promise<Stripped> {
  const parts = await partsOf(file);
  return parts
    ? { blob: new Blob(parts.parts, { type: file.type }), clean: parts.clean }
    : { blob: file, clean: false };
}

async function partsOf(file: Blob): Promise<{ parts: BlobPart[]; clean: boolean } | null> {
  const head = new Uint8Array(await file.slice(0, 256).arrayBuffer());
  const text = String.fromCharCode(...head.subarray(0, 12));
  if (await isPng(file)) return whole(await pngParts(file));
  if (text.slice(4, 8) === 'ftyp' && !foreignKind(head)) return filmParts(file);
  if (['moov', 'mdat', 'wide', 'skip'].includes(text.slice(4, 8))) return filmParts(file);
  if (file.size > MOST_BYTES) return null;
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (text.startsWith('\xff\xd8\xff')) return whole(jpegParts(bytes, file));
  if (text.startsWith('RIFF') && text.endsWith('WEBP')) return whole(webpParts(bytes, file));
  if (text.startsWith('GIF8')) return whole(gifParts(bytes, file));
  if (text.startsWith('BM')) return whole(bmpParts(bytes));
  if (/^(II\*\0|MM\0\*)/.test(text)) return tiffParts(bytes);
  return foreignKind(head) ? itemParts(bytes) : null;
}

function whole(parts: BlobPart[] | null) {
  return parts && { parts, clean: true };
}

/** @returns null if the file is incomplete */
async function pngParts(file: Blob): Promise<BlobPart[] | null> {
  const chunks = await chunksOf(file);
  if (!chunks) return null;
  const record = chunks.find(({ type }) => type === 'eXIf');
  const data = record && (await dataOf(file, record));
  const orientation = data ? orientationOf(new Uint8Array(await data.arrayBuffer())) : 1;
  const kept = chunks.filter(({ type }) => PNG_CHUNKS.includes(type)).map((chunk) => wholeChunk(file, chunk));
  const said = orientation > 1 ? [await chunkOf('eXIf', recordOf(orientation))] : [];
  return [pngOf([...kept.slice(0, 1), ...said, ...kept.slice(1)])];
}
