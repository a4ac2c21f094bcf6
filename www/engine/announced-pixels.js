// @ts-check
/**
 * How many pixels a photo has, as the head of its file says: enough to know how long reading it may take. Whether that is
 * true, and whether it is too much, the decoders tell.
 */

/** What the core takes at most; more it refuses, which is quickly done. */
const MOST = 120_000_000;
/** Of a file that does not say it in a way known here. */
const PIXELS_A_BYTE = 10;

/**
 * @param {Uint8Array} bytes of a file
 * @returns {number}
 */
export function announcedPixels(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let size;
  try {
    size = jpeg(view) ?? png(view) ?? gif(view) ?? bmp(view) ?? webp(view) ?? tiff(view);
  } catch {
    // The file ends before it says it.
  }
  const pixels = size ? size[0] * size[1] : bytes.length * PIXELS_A_BYTE;
  return Math.min(MOST, pixels);
}

/** @typedef {[number, number] | null} Size null: it is no file of that kind */

/** @param {DataView} view @param {number} at @param {string} text */
function says(view, at, text) {
  return [...text].every((letter, i) => view.getUint8(at + i) === letter.charCodeAt(0));
}

/** @param {DataView} view @returns {Size} */
function jpeg(view) {
  if (view.getUint16(0) !== 0xffd8) return null;
  for (let at = 2; view.getUint8(at) === 0xff;) {
    const marker = view.getUint8(at + 1);
    // Frames of all kinds; the three in between are tables.
    if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker)) return [view.getUint16(at + 7), view.getUint16(at + 5)];
    at += marker === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
  return null;
}

/** @param {DataView} view @returns {Size} */
function png(view) {
  return says(view, 1, 'PNG') ? [view.getUint32(16), view.getUint32(20)] : null;
}

/** @param {DataView} view @returns {Size} */
function gif(view) {
  return says(view, 0, 'GIF8') ? [view.getUint16(6, true), view.getUint16(8, true)] : null;
}

/** @param {DataView} view @returns {Size} */
function bmp(view) {
  return says(view, 0, 'BM') ? [Math.abs(view.getInt32(18, true)), Math.abs(view.getInt32(22, true))] : null;
}

/** @param {DataView} view @returns {Size} */
function webp(view) {
  if (!says(view, 0, 'RIFF') || !says(view, 8, 'WEBP')) return null;
  const three = (/** @type {number} */ at) => view.getUint16(at, true) + 2 ** 16 * view.getUint8(at + 2);
  if (says(view, 12, 'VP8X')) return [three(24) + 1, three(27) + 1];
  if (says(view, 12, 'VP8L')) {
    const bits = view.getUint32(21, true);
    return [(bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1];
  }
  return says(view, 12, 'VP8 ') ? [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff] : null;
}

/** @param {DataView} view @returns {Size} of its first picture */
function tiff(view) {
  const little = says(view, 0, 'II*');
  if (!little && !says(view, 0, 'MM\0*')) return null;
  const list = view.getUint32(4, little);
  /** @type {[number, number]} */
  const size = [0, 0];
  for (let i = 0; i < view.getUint16(list, little); i += 1) {
    const at = list + 2 + 12 * i;
    const side = view.getUint16(at, little) - 256;
    if (side !== 0 && side !== 1) continue;
    size[side] = view.getUint16(at + 2, little) === 3 ? view.getUint16(at + 8, little) : view.getUint32(at + 8, little);
  }
  return size[0] > 0 && size[1] > 0 ? size : null;
}
