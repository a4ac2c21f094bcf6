/** Headers of photos, which the core reads before the photos are decoded. They serve the sketch of the first page. */

/** Bytes at the beginning of a file. Its metadata and its size are usually in them. */
const HEAD = 128 * 2 ** 10;
/** Quarter turns clockwise that make a photo of an orientation upright; mirrored photos are only turned. */
const TURNS: Readonly<Record<number, number>> = { 3: 2, 4: 2, 5: 1, 6: 1, 7: 3, 8: 3 };

export type Size = { width: number; height: number };
/** `size` of the upright photo; `thumbnail`: the JPEG file that the camera stored, before its turn */
export type PhotoHeader = { size: Size; thumbnail: Blob | null; turn: number };
export type Thumbnail = { bitmap: ImageBitmap; turn: number };

/**
 * Reads a header. The core must be started.
 * @returns null for a file of an unknown kind, and for a damaged one, whose import reports the error
 */
export async function photoHeader(file: Blob): Promise<PhotoHeader | null> {
  try {
    const [{ photo_header }, head] = await Promise.all([
      import('../pkg/inkpanel.js'),
      file.slice(0, HEAD).arrayBuffer(),
    ]);
    const header = photo_header(new Uint8Array(head));
    if (!header) return null;
    const { width, height, thumbnail, orientation } = header;
    header.free();
    return {
      size: { width, height },
      thumbnail: thumbnail ? new Blob([thumbnail as BlobPart], { type: 'image/jpeg' }) : null,
      turn: TURNS[orientation] ?? 0,
    };
  } catch {
    return null;
  }
}

/** @returns null without a readable thumbnail */
export async function decodeThumbnail({ thumbnail, turn }: PhotoHeader): Promise<Thumbnail | null> {
  try {
    return thumbnail && { bitmap: await createImageBitmap(thumbnail, { imageOrientation: 'from-image' }), turn };
  } catch {
    return null;
  }
}
