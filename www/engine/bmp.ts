/** Writer of BMP files, which need no compression. */

/** Bytes before the pixels. */
const HEADER = 54;

/** @param picture RGBA; rotate clockwise by this many degrees, then mirror */
export function bmp({
  width,
  height,
  data,
  rotation = 0,
  flip = false,
}: {
  width: number;
  height: number;
  data: Uint8Array | Uint8ClampedArray;
  rotation?: number;
  flip?: boolean;
}): Uint8Array<ArrayBuffer> {
  const [columns, rows] = rotation % 180 === 0 ? [width, height] : [height, width];
  /** Position of a pixel of the upright image. */
  const place = (x: number, y: number) => {
    const across = flip ? columns - 1 - x : x;
    if (rotation === 90) return 4 * ((height - 1 - across) * width + y);
    if (rotation === 180) return 4 * ((height - 1 - y) * width + width - 1 - across);
    if (rotation === 270) return 4 * (across * width + width - 1 - y);
    return 4 * (y * width + across);
  };
  const step = place(1, 0) - place(0, 0);
  const stride = 4 * Math.ceil((3 * columns) / 4);
  const file = new Uint8Array(HEADER + stride * rows);
  const view = new DataView(file.buffer);
  file.set([0x42, 0x4d]);
  // Length, offset of the pixels, header size, width and height (negative: from top to bottom), planes, bits.
  for (const [at, value] of [
    [2, file.length],
    [10, HEADER],
    [14, 40],
    [18, columns],
    [22, -rows],
  ])
    view.setInt32(at, value, true);
  view.setUint16(26, 1, true);
  view.setUint16(28, 24, true);
  for (let y = 0; y < rows; y += 1) {
    let from = place(0, y);
    for (let to = HEADER + y * stride, end = to + 3 * columns; to < end; to += 3, from += step) {
      const alpha = data[from + 3];
      const ground = 255 * (255 - alpha) + 127;
      file[to] = (data[from + 2] * alpha + ground) / 255;
      file[to + 1] = (data[from + 1] * alpha + ground) / 255;
      file[to + 2] = (data[from] * alpha + ground) / 255;
    }
  }
  return file;
}
