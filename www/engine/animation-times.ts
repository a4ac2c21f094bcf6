/**
 * End times of the frames of an animated GIF or WebP file, read only from the headers of its frames. Sources: GIF89a
 * specification, sections 18 to 26; WebP container specification.
 */

/** Maximum number of pictures, and of pixels of all pictures together: about ten seconds of decoding. */
const MOST_PICTURES = 3000;
const MOST_PIXELS = 1.5e9;
/** Maximum size of a file that is parsed. */
const MOST_BYTES = 256 * 2 ** 20;
/** Bytes up to the flags of a WebP file. */
const WEBP_HEAD = 21;
/** Delay in seconds that browsers use for delays of 10 ms or less. */
const SHORTEST = 0.1;

/** Whether a file is worth a look. */
export function mayMove(file: Blob & { name?: string }): boolean {
  return /^image\/(gif|webp)$/.test(file.type) || /\.(gif|webp)$/i.test(file.name ?? '');
}

/** @returns the ends in seconds, rising; empty for still images and other files. Only files with animations are read whole. */
export async function pictureEnds(file: Blob & { name?: string }): Promise<number[]> {
  if (!mayMove(file) || file.size > MOST_BYTES) return [];
  try {
    if (isStillWebp(new Uint8Array(await file.slice(0, WEBP_HEAD).arrayBuffer()))) return [];
    return endsOf(new Uint8Array(await file.arrayBuffer()));
  } catch {
    // A file that cannot be read is reported when it is decoded.
    return [];
  }
}

/**
 * Returns whether a file is a still WebP image. Only the extended format (`VP8X`) can contain animations, and it has a flag
 * for them.
 * @param head the first bytes of the file
 */
function isStillWebp(head: Uint8Array): boolean {
  const text = (from: number, to: number) => String.fromCharCode(...head.subarray(from, to));
  if (text(0, 4) !== 'RIFF' || text(8, 12) !== 'WEBP' || head.length < WEBP_HEAD) return false;
  return text(12, 16) !== 'VP8X' || (head[20] & 2) === 0;
}

/** @param bytes of a file */
export function endsOf(bytes: Uint8Array): number[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = (from: number, to: number) => String.fromCharCode(...bytes.subarray(from, to));
  const { delays, pixels } =
    text(0, 4) === 'GIF8'
      ? ofGif(bytes, view)
      : text(0, 4) === 'RIFF' && text(8, 12) === 'WEBP'
        ? ofWebp(view, text)
        : { delays: [], pixels: 1 };
  if (delays.length < 2) return [];
  let end = 0;
  const most = Math.min(MOST_PICTURES, Math.floor(MOST_PIXELS / Math.max(1, pixels)));
  return delays.slice(0, Math.max(1, most)).map((delay) => (end += delay > 0.01 ? delay : SHORTEST));
}

function ofGif(bytes: Uint8Array, view: DataView) {
  const delays: number[] = [];
  if (bytes.length < 13) return { delays, pixels: 1 };
  const pixels = view.getUint16(6, true) * view.getUint16(8, true);
  const colours = (flags: number) => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  const blocks = (at: number) => {
    while (bytes[at] > 0) at += 1 + bytes[at];
    return at + 1;
  };
  let at = 13 + colours(bytes[10]);
  let delay = 0;
  while (at + 10 <= bytes.length) {
    if (bytes[at] === 0x21) {
      if (bytes[at + 1] === 0xf9) delay = view.getUint16(at + 4, true) / 100;
      at = blocks(at + 2);
    } else if (bytes[at] === 0x2c) {
      delays.push(delay);
      delay = 0;
      at = blocks(at + 11 + colours(bytes[at + 9]));
    } else break;
  }
  return { delays, pixels };
}

function ofWebp(view: DataView, text: (from: number, to: number) => string) {
  const delays: number[] = [];
  let pixels = 1;
  const three = (at: number) => view.getUint16(at, true) + 65_536 * view.getUint8(at + 2);
  for (let at = 12; at + 24 <= view.byteLength; at += 8 + 2 * Math.ceil(view.getUint32(at + 4, true) / 2)) {
    const kind = text(at, at + 4);
    if (kind === 'VP8X') pixels = (three(at + 12) + 1) * (three(at + 15) + 1);
    if (kind === 'ANMF') delays.push(three(at + 20) / 1000);
  }
  return { delays, pixels };
}
