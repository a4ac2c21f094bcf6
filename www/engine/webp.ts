/**
 * The browser's WebP encoder: detection, and the resolution (DPI), which it omits. Layout of the file after RFC 9649,
 * of the resolution after Exif 2.32.
 */

const EXIF_FLAG = 0x08;
const ALPHA_FLAG = 0x10;
/** Numbers of the fields, and of their types. */
const [ACROSS, DOWN, UNIT] = [282, 283, 296];
const [SHORT, RATIONAL] = [3, 5];
const INCHES = 2;

let tried: Promise<boolean> | undefined;

/** @returns whether the browser encodes WebP; some browsers return PNG instead */
export function givesWebp(): Promise<boolean> {
  tried ??= (async () => {
    const canvas = new OffscreenCanvas(1, 1);
    canvas.getContext('2d');
    return (await canvas.convertToBlob({ type: 'image/webp', quality: 0.5 })).type === 'image/webp';
  })().catch(() => false);
  return tried;
}

/** @returns the same image with its resolution in DPI */
export function withDpi(
  file: Uint8Array<ArrayBuffer>,
  { width, height, dpi }: { width: number; height: number; dpi: number },
): Blob {
  const chunks = chunksOf(file).filter(({ name }) => name !== 'EXIF');
  const head = chunks.find(({ name }) => name === 'VP8X')?.data.slice() ?? extended(chunks, width, height);
  head[0] |= EXIF_FLAG;
  const parts = [
    chunk('VP8X', head),
    ...chunks.filter(({ name }) => name !== 'VP8X').map(({ name, data }) => chunk(name, data)),
    chunk('EXIF', exif(dpi)),
  ];
  return fileOf(parts);
}

/** @returns a file of chunks */
export function fileOf(parts: readonly Uint8Array<ArrayBuffer>[]): Blob {
  const riff = new Uint8Array(12);
  riff.set(letters('RIFF'));
  new DataView(riff.buffer).setUint32(4, 4 + parts.reduce((sum, part) => sum + part.length, 0), true);
  riff.set(letters('WEBP'), 8);
  return new Blob([riff, ...parts], { type: 'image/webp' });
}

export function chunksOf(file: Uint8Array<ArrayBuffer>): { name: string; data: Uint8Array<ArrayBuffer> }[] {
  const view = new DataView(file.buffer, file.byteOffset, file.length);
  const found = [];
  for (let at = 12; at + 8 <= file.length; ) {
    const length = view.getUint32(at + 4, true);
    found.push({
      name: String.fromCharCode(...file.subarray(at, at + 4)),
      data: file.subarray(at + 8, at + 8 + length),
    });
    at += 8 + length + (length % 2);
  }
  return found;
}

/** The chunk that files with more than pixels begin with. */
function extended(chunks: { name: string; data: Uint8Array }[], width: number, height: number) {
  const data = new Uint8Array(10);
  // The header of a lossless image has an alpha flag.
  const lossless = chunks.find(({ name }) => name === 'VP8L');
  if (lossless && lossless.data[4] & ALPHA_FLAG) data[0] |= ALPHA_FLAG;
  for (let i = 0; i < 3; i += 1) {
    data[4 + i] = (width - 1) >> (8 * i);
    data[7 + i] = (height - 1) >> (8 * i);
  }
  return data;
}

/** @returns a complete chunk */
export function chunk(name: string, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(8 + data.length + (data.length % 2));
  bytes.set(letters(name));
  new DataView(bytes.buffer).setUint32(4, data.length, true);
  bytes.set(data, 8);
  return bytes;
}

/** One directory of three fields; the dots follow it. */
function exif(dpi: number) {
  const view = new DataView(new ArrayBuffer(66));
  const fields = [
    [ACROSS, RATIONAL, 50],
    [DOWN, RATIONAL, 58],
    [UNIT, SHORT, INCHES],
  ];
  view.setUint32(0, 0x49492a00);
  view.setUint32(4, 8, true);
  view.setUint16(8, fields.length, true);
  fields.forEach(([field, type, value], i) => {
    const at = 10 + 12 * i;
    view.setUint16(at, field, true);
    view.setUint16(at + 2, type, true);
    view.setUint32(at + 4, 1, true);
    view.setUint32(at + 8, value, true);
  });
  for (const at of [50, 58]) {
    view.setUint32(at, dpi, true);
    view.setUint32(at + 4, 1, true);
  }
  return new Uint8Array(view.buffer);
}

function letters(name: string) {
  return Uint8Array.from(name, (letter) => letter.charCodeAt(0));
}
