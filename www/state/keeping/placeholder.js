// @ts-check
/**
 * The picture in the place of a photo that is not there: an empty frame with its diagonals, as editors of pages draw it.
 * It is light, so that every style leaves it light, and has the shape of the photo, so that its crop stays what it was.
 */

import { chunkOf, pngOf } from '../../engine/png-chunks.js';

/** Pixels of the longer side, and of a line. */
const [LONGEST, LINE] = [480, 2];
const [GROUND, INK] = [236, 196];

/**
 * @param {{ width: number, height: number }} photo
 * @returns {Promise<Blob>} a PNG
 */
export async function placeholderOf(photo) {
  const scale = LONGEST / Math.max(photo.width, photo.height);
  const [width, height] = [photo.width, photo.height].map((side) => Math.max(8, Math.round(side * scale)));
  // Each row begins with the kind of its prediction, which is none.
  const rows = new Uint8Array((width + 1) * height).fill(GROUND);
  const longer = Math.hypot(width, height);
  for (let y = 0; y < height; y += 1) {
    const row = y * (width + 1);
    rows[row] = 0;
    for (let x = 0; x < width; x += 1) {
      const [fall, rise] = [x * height - y * width, x * height - (height - y) * width];
      const edge = Math.min(x, y, width - 1 - x, height - 1 - y) < LINE;
      if (edge || Math.min(Math.abs(fall), Math.abs(rise)) < LINE * longer / 2) rows[row + 1 + x] = INK;
    }
  }
  const head = new DataView(new ArrayBuffer(13));
  head.setUint32(0, width);
  head.setUint32(4, height);
  // Eight bits of grey.
  head.setUint8(8, 8);
  const pixels = await new Response(new Blob([rows]).stream().pipeThrough(new CompressionStream('deflate'))).blob();
  return pngOf([await chunkOf('IHDR', new Uint8Array(head.buffer)), await chunkOf('IDAT', pixels), await chunkOf('IEND', new Blob([]))]);
}
