/**
 * Thumbnails that cameras store in JPEG files, as EXIF metadata. They are shown in the sketch of the first page, before
 * the photos are decoded.
 */

/** Maximum bytes before the end of the EXIF segment: other segments may precede it. */
const HEAD = 128 * 2 ** 10;
const [SOI, APP1, JPEG_START, JPEG_LENGTH, ORIENTATION] = [0xffd8, 0xffe1, 0x0201, 0x0202, 0x0112];
/** Bytes per entry of a TIFF directory. */
const ENTRY = 12;

/** `turn`: quarter turns clockwise that make it upright; mirrored photos are only turned */
export type ExifThumbnail = { bitmap: ImageBitmap; turn: number };

/** @returns null for a file without a readable thumbnail */
export async function exifThumbnail(file: Blob): Promise<ExifThumbnail | null> {
  try {
    const found = findThumbnail(new DataView(await file.slice(0, HEAD).arrayBuffer()));
    if (!found) return null;
    const { start, end, turn } = found;
    const bitmap = await createImageBitmap(file.slice(start, end, 'image/jpeg'), { imageOrientation: 'from-image' });
    return { bitmap, turn };
  } catch {
    // The file is damaged or cannot be read. Its import reports the error.
    return null;
  }
}

/**
 * @param head the first bytes of a file
 * @returns the position of the thumbnail in the file
 * @throws `RangeError` if the metadata is truncated
 */
export function findThumbnail(head: DataView): { start: number; end: number; turn: number } | null {
  if (head.byteLength < 4 || head.getUint16(0) !== SOI) return null;
  let at = 2;
  while (head.getUint8(at) === 0xff && !isExif(head, at)) {
    // Pixels follow the segment SOS.
    if (head.getUint8(at + 1) === 0xda) return null;
    at += 2 + head.getUint16(at + 2);
  }
  if (!isExif(head, at)) return null;
  const tiff = at + 10;
  const little = head.getUint16(tiff) === 0x4949;
  const first = directory(head, tiff, tiff + head.getUint32(tiff + 4, little), little);
  if (first.next === 0) return null;
  const second = directory(head, tiff, tiff + first.next, little);
  const [offset, length] = [second.values.get(JPEG_START), second.values.get(JPEG_LENGTH)];
  if (offset === undefined || !length || tiff + offset + length > at + 2 + head.getUint16(at + 2)) return null;
  const turn = { 3: 2, 4: 2, 5: 1, 6: 1, 7: 3, 8: 3 }[first.values.get(ORIENTATION) ?? 1] ?? 0;
  return { start: tiff + offset, end: tiff + offset + length, turn };
}

function isExif(head: DataView, at: number): boolean {
  return head.getUint16(at) === APP1 && head.getUint32(at + 4) === 0x45786966;
}

/** The numbers of a TIFF directory by tag, and the offset of the next directory. */
function directory(head: DataView, tiff: number, at: number, little: boolean) {
  const count = head.getUint16(at, little);
  const values: Map<number, number> = new Map();
  for (let i = 0; i < count; i += 1) {
    const entry = at + 2 + i * ENTRY;
    const isShort = head.getUint16(entry + 2, little) === 3;
    const value = isShort ? head.getUint16(entry + 8, little) : head.getUint32(entry + 8, little);
    values.set(head.getUint16(entry, little), value);
  }
  return { values, next: head.getUint32(at + 2 + count * ENTRY, little) };
}
