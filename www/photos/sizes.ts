/**
 * Sizes of photos from the headers of JPEG, PNG and WebP files, before the photos are decoded. Other formats are unknown
 * until then. Source: ITU-T T.81, annex B; PNG (third edition), 11.2.1; RFC 9649.
 */

import { orientationOf } from '../engine/metadata/exif.ts';
import { APP1, EXIF, SCAN } from '../engine/metadata/jpeg.ts';
import { after } from '../engine/scheduler.ts';

export type Size = { width: number; height: number };

/** Maximum time in ms, because the sketch of the first page waits for the sizes. */
const WAIT = 100;
/** Maximum number of files, which is enough for a first page. */
const MOST = 40;
/** Maximum bytes before the end of the header: it follows the metadata. */
const HEAD = 128 * 2 ** 10;
const [JPEG, PNG, IHDR, WEBP] = [0xffd8, 0x89504e47, 0x49484452, 0x57454250];
/** First chunks of a WebP file: lossy, lossless, extended. */
const [VP8, VP8L, VP8X] = [0x56503820, 0x5650384c, 0x56503858];
/** Markers in the range of frames that begin tables and extensions. */
const NO_FRAME = [0xc4, 0xc8, 0xcc];

/**
 * @param read reads the size of one file
 * @returns the sizes that are known in time
 */
export async function sizesOf(
  files: readonly File[],
  read: (file: File) => Promise<Size | null> = sizeOf,
): Promise<ReadonlyMap<File, Size>> {
  const sizes: Map<File, Size> = new Map();
  const all = files.slice(0, MOST).map(async (file) => {
    const size = await read(file).catch(() => null);
    if (size && size.width > 0 && size.height > 0) sizes.set(file, size);
  });
  let stop = () => {};
  const end = new Promise<void>((resolve) => {
    stop = after(WAIT, resolve);
  });
  await Promise.race([Promise.all(all), end]);
  stop();
  return new Map(sizes);
}

/**
 * @returns the size of the upright photo, or null if it is unknown
 * @throws `RangeError` if the header is truncated
 */
export async function sizeOf(file: Blob): Promise<Size | null> {
  const bytes = new Uint8Array(await file.slice(0, HEAD).arrayBuffer());
  const view = new DataView(bytes.buffer);
  if (view.getUint32(0) === PNG && view.getUint32(12) === IHDR)
    return { width: view.getUint32(16), height: view.getUint32(20) };
  if (view.getUint32(8) === WEBP) return sizeOfWebp(view);
  return view.getUint16(0) === JPEG ? sizeOfJpeg(view, bytes) : null;
}

function sizeOfWebp(view: DataView): Size | null {
  const low14 = (at: number) => view.getUint16(at, true) & 0x3fff;
  const chunk = view.getUint32(12);
  if (chunk === VP8) return { width: low14(26), height: low14(28) };
  const low24 = (at: number) => view.getUint32(at, true) & 0xffffff;
  if (chunk === VP8X) return { width: 1 + low24(24), height: 1 + low24(27) };
  if (chunk === VP8L) return { width: 1 + low14(21), height: 1 + ((view.getUint32(21, true) >>> 14) & 0x3fff) };
  return null;
}

function sizeOfJpeg(view: DataView, bytes: Uint8Array): Size | null {
  let orientation = 1;
  for (let at = 2; view.getUint8(at) === 0xff; at += 2 + view.getUint16(at + 2)) {
    const marker = view.getUint8(at + 1);
    if (marker === SCAN) return null;
    const from = at + 4;
    const begins = (text: string) => [...text].every((letter, i) => bytes[from + i] === letter.charCodeAt(0));
    if (marker === APP1 && begins(EXIF)) orientation = orientationOf(bytes.subarray(from + EXIF.length));
    if (marker >= 0xc0 && marker <= 0xcf && !NO_FRAME.includes(marker)) {
      const [height, width] = [view.getUint16(from + 1), view.getUint16(from + 3)];
      // From 5 on, an orientation swaps the sides.
      return orientation < 5 ? { width, height } : { width: height, height: width };
    }
  }
  return null;
}
