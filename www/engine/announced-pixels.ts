/**
 * Number of pixels of a photo, from the header of its file. It limits the time for reading the file. The decoders check
 * the number and the limits.
 */

/** Limit of the core. It rejects larger photos quickly. */
const MOST = 120_000_000;
/** Estimate for files without a known header. */
const PIXELS_A_BYTE = 10;

/** @param bytes of a file */
export function announcedPixels(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let size: ReturnType<typeof jpeg> = null;
  try {
    size = jpeg(view) ?? png(view) ?? gif(view) ?? bmp(view) ?? webp(view) ?? tiff(view);
  } catch {
    // The file ends before its size.
  }
  const pixels = size ? size[0] * size[1] : bytes.length * PIXELS_A_BYTE;
  return Math.min(MOST, pixels);
}

/** null: a file of another kind */
type Size = [number, number] | null;

function says(view: DataView, at: number, text: string) {
  return [...text].every((letter, i) => view.getUint8(at + i) === letter.charCodeAt(0));
}

function jpeg(view: DataView): Size {
  if (view.getUint16(0) !== 0xffd8) return null;
  for (let at = 2; view.getUint8(at) === 0xff; ) {
    const marker = view.getUint8(at + 1);
    // Frames of all kinds; the three in between are tables.
    if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker))
      return [view.getUint16(at + 7), view.getUint16(at + 5)];
    at += marker === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
  return null;
}

function png(view: DataView): Size {
  return says(view, 1, 'PNG') ? [view.getUint32(16), view.getUint32(20)] : null;
}

function gif(view: DataView): Size {
  return says(view, 0, 'GIF8') ? [view.getUint16(6, true), view.getUint16(8, true)] : null;
}

function bmp(view: DataView): Size {
  return says(view, 0, 'BM') ? [Math.abs(view.getInt32(18, true)), Math.abs(view.getInt32(22, true))] : null;
}

function webp(view: DataView): Size {
  if (!says(view, 0, 'RIFF') || !says(view, 8, 'WEBP')) return null;
  const three = (at: number) => view.getUint16(at, true) + 2 ** 16 * view.getUint8(at + 2);
  if (says(view, 12, 'VP8X')) return [three(24) + 1, three(27) + 1];
  if (says(view, 12, 'VP8L')) {
    const bits = view.getUint32(21, true);
    return [(bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1];
  }
  return says(view, 12, 'VP8 ') ? [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff] : null;
}

/** @returns of its first picture */
function tiff(view: DataView): Size {
  const little = says(view, 0, 'II*');
  if (!little && !says(view, 0, 'MM\0*')) return null;
  const list = view.getUint32(4, little);
  const size: [number, number] = [0, 0];
  for (let i = 0; i < view.getUint16(list, little); i += 1) {
    const at = list + 2 + 12 * i;
    const side = view.getUint16(at, little) - 256;
    if (side !== 0 && side !== 1) continue;
    size[side] = view.getUint16(at + 2, little) === 3 ? view.getUint16(at + 8, little) : view.getUint32(at + 8, little);
  }
  return size[0] > 0 && size[1] > 0 ? size : null;
}
