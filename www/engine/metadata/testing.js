// @ts-check
/** Records as a telephone writes them, for the tests of what is taken out. */

/** What must be found nowhere afterwards; the last two are 46 degrees and 12 minutes, in both byte orders. */
export const SECRETS = ['SECRET', 'Phone 99', '2021:05:06', '\x2e\0\0\0\x01\0\0\0\x0c\0\0\0\x01', '\0\0\0\x2e\0\0\0\x01\0\0\0\x0c'];

/** @param {string} text */
const ascii = (text) => [...text].map((letter) => letter.charCodeAt(0));

/**
 * A record of two directories: camera, date, orientation, place and EXIF, and then a thumbnail.
 * @param {{ orientation?: number, little?: boolean, pixels?: boolean }} [how] `pixels`: with the fields of a TIFF picture of 2 x 2
 */
export function record({ orientation = 6, little = true, pixels = false } = {}) {
  /** @type {number[]} */
  const bytes = [];
  const put = (/** @type {number} */ at, /** @type {number} */ value, /** @type {number} */ size) => {
    for (let i = 0; i < size; i += 1) bytes[at + i] = (value >>> (8 * (little ? i : size - 1 - i))) & 0xff;
  };
  const SIZE = [0, 1, 1, 2, 4, 8, 1, 1];
  /** Writes a directory and what does not fit into it. @param {number} at @param {[tag: number, type: number, values: number[]][]} fields @param {number} next */
  const directory = (at, fields, next) => {
    put(at, fields.length, 2);
    let free = at + 2 + 12 * fields.length + 4;
    fields.forEach(([tag, type, values], i) => {
      const field = at + 2 + 12 * i;
      put(field, tag, 2);
      put(field + 2, type, 2);
      put(field + 4, type === 5 ? values.length / 2 : values.length, 4);
      const step = type === 5 ? 4 : SIZE[type];
      const length = step * values.length;
      put(field + 8, 0, 4);
      if (length > 4) put(field + 8, free, 4);
      values.forEach((value, j) => put((length > 4 ? free : field + 8) + j * step, value, step));
      if (length > 4) free += length + (length % 2);
    });
    put(at + 2 + 12 * fields.length, next, 4);
  };
  bytes.push(...(little ? [0x49, 0x49, 0x2a, 0] : [0x4d, 0x4d, 0, 0x2a]));
  put(4, 8, 4);
  const text = (/** @type {string} */ value) => ascii(`${value}\0`);
  /** @type {[number, number, number[]][]} */
  const picture = pixels ? [[256, 3, [2]], [257, 3, [2]], [258, 3, [8]], [259, 3, [1]], [262, 3, [1]]] : [];
  /** @type {[number, number, number[]][]} */
  const strip = pixels ? [[273, 4, [1200]]] : [];
  /** @type {[number, number, number[]][]} */
  const rows = pixels ? [[277, 3, [1]], [278, 3, [2]], [279, 4, [4]]] : [];
  directory(8, [
    ...picture, [0x10e, 2, text('SECRET words')], [0x10f, 2, text('SECRET')], [0x110, 2, text('Phone 99')], ...strip, [0x112, 3, [orientation]], ...rows,
    [0x132, 2, text('2021:05:06 07:08:09')], [0x13b, 2, text('SECRET name')], [0x8769, 4, [500]], [0x8825, 4, [800]],
  ], pixels ? 0 : 1000);
  directory(500, [[0x9003, 2, text('2021:05:06 07:08:09')], [0x927c, 7, ascii('SECRET note of the maker')], [0xa431, 2, text('SECRET number')]], 0);
  directory(800, [[1, 2, text('N')], [2, 5, [46, 1, 12, 1, 3, 1]], [3, 2, text('E')], [0x1d, 2, text('2021:05:06')]], 0);
  if (!pixels) {
    directory(1000, [[0x201, 4, [1100]], [0x202, 4, [16]]], 0);
    ascii('SECRET thumbnail').forEach((value, i) => { bytes[1100 + i] = value; });
  }
  [11, 22, 33, 44].forEach((value, i) => { bytes[1200 + i] = value; });
  return Uint8Array.from({ length: 1204 }, (_, i) => bytes[i] ?? 0);
}

/** @param {string} type @param {(Uint8Array | string)[]} content @returns {Uint8Array<ArrayBuffer>} a box of MP4 and HEIC */
export function box(type, ...content) {
  const parts = content.map((part) => (typeof part === 'string' ? Uint8Array.from(ascii(part)) : part));
  const length = parts.reduce((sum, part) => sum + part.length, 8);
  const made = new Uint8Array(length);
  new DataView(made.buffer).setUint32(0, length);
  made.set(ascii(type), 4);
  let at = 8;
  for (const part of parts) {
    made.set(part, at);
    at += part.length;
  }
  return made;
}

/** @param {number} marker @param {(Uint8Array<ArrayBuffer> | string)[]} content @returns {Blob} a segment of a JPEG */
export function segment(marker, ...content) {
  const body = new Blob(content);
  return new Blob([Uint8Array.of(0xff, marker, (body.size + 2) >> 8, (body.size + 2) & 0xff), body]);
}

/** @param {Blob} photo a JPEG @returns {Blob} the same with all that a telephone writes, and a film behind its end */
export function loaded(photo) {
  const said = [
    segment(0xe1, 'Exif\0\0', record()), segment(0xe1, 'http://ns.adobe.com/xap/1.0/\0<x:xmpmeta>SECRET</x:xmpmeta>'),
    segment(0xe2, 'MPF\0SECRET'), segment(0xed, 'Photoshop 3.0\0SECRET'), segment(0xfe, 'SECRET comment'),
  ];
  return new Blob([photo.slice(0, 2), ...said, photo.slice(2), box('moov', box('udta', 'SECRET place'))], { type: 'image/jpeg' });
}
