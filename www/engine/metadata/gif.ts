/** Removes metadata from GIF files. Source: GIF89a Specification. */

const [EXTENSION, PICTURE, END] = [0x21, 0x2c, 0x3b];
const [TIMES, APPLICATION] = [0xf9, 0xff];
/** How often it plays, in one block of three bytes, and its colours. */
const APPLICATIONS: Record<string, number> = { 'NETSCAPE2.0': 1, 'ANIMEXTS1.0': 1, ICCRGBG1012: Infinity };

/**
 * @param file the same
 * @returns null if the file is incomplete
 */
export function gifParts(bytes: Uint8Array<ArrayBuffer>, file: Blob): BlobPart[] | null {
  const table = (flags: number) => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  const head = 13 + table(bytes[10]);
  const parts: BlobPart[] = [file.slice(0, head)];
  for (let at = head; at < bytes.length; ) {
    const [start, kind] = [at, bytes[at]];
    if (kind === END) return [...parts, file.slice(at, at + 1)];
    if (kind !== PICTURE && kind !== EXTENSION) return null;
    const body = start + (kind === PICTURE ? 11 + table(bytes[start + 9]) : 2);
    const ends = blocksAt(bytes, body);
    if (!ends) return null;
    at = ends[ends.length - 1];
    if (kind === PICTURE) {
      parts.push(file.slice(start, at));
      continue;
    }
    const most = blocksOf(bytes, start);
    if (most === 0) continue;
    const stays = Math.min(most, ends.length - 1);
    parts.push(file.slice(start, ends[stays - 1]), Uint8Array.of(0));
  }
  return null;
}

/** @returns the end of each block, including the last, empty one; null if they are truncated */
function blocksAt(bytes: Uint8Array, at: number): number[] | null {
  const ends: number[] = [];
  while (at < bytes.length) {
    const length = bytes[at];
    at += 1 + length;
    ends.push(at);
    if (length === 0) return ends;
  }
  return null;
}

/**
 * @param at where an extension begins
 * @returns number of its blocks that the pixels need
 */
function blocksOf(bytes: Uint8Array, at: number): number {
  const [label, length] = [bytes[at + 1], bytes[at + 2]];
  if (label === TIMES) return length === 4 ? 1 : 0;
  if (label !== APPLICATION || length !== 11) return 0;
  const most = APPLICATIONS[String.fromCharCode(...bytes.subarray(at + 3, at + 14))] ?? 0;
  return most === 0 || (most === 1 && bytes[at + 14] !== 3) ? 0 : 1 + most;
}
