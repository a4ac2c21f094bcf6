/**
 * Removes metadata from TIFF files. Positions in such a file are absolute, so preserved data stays in place: allowed
 * fields, their values and the pixels. Everything else is blanked, or removed after the last preserved byte. Sources:
 * TIFF 6.0; TIFF Technical Note 2; ICC.1, annex B.3.
 */

import { blankAround, joined, meet } from './ranges.ts';
import type { Range } from './ranges.ts';

/** `at` is the offset of its value, inside or outside of the field; `length` is the size of the value in bytes. */
type Field = { tag: number; type: number; count: number; at: number; length: number };
/** `place` is its position. */
type Directory = { place: number; end: number; fields: Field[]; next: number };

/** Tags that each image needs. */
const NEEDED = new Set([
  254,
  255, // which kind of picture it is
  256,
  257,
  258,
  259,
  262,
  266,
  274,
  277,
  284, // sides, bits, compression, colours, order of bits, which side is up, samples, planes
  273,
  278,
  279, // strips
  322,
  323,
  324,
  325, // tiles
  263,
  264,
  265,
  280,
  281,
  290,
  291,
  301,
  318,
  319,
  320,
  332,
  334,
  336,
  338,
  339,
  340,
  341,
  342, // interpretation of samples
  282,
  283,
  296, // resolution
  292,
  293,
  317,
  347,
  50674, // LERC parameters
  529,
  530,
  531,
  532, // luma and chroma
  34675, // the colour profile
]);

const [KIND, COMPRESSION, SUB_DIRECTORIES, DNG] = [254, 259, 330, 50706];
/** Tags of offsets and lengths of pixels: strips, tiles. */
const PIXELS = [
  [273, 279],
  [324, 325],
];
/** A kind: a smaller copy of another picture. */
const REDUCED = 1;
/** JPEG as it was done before Technical Note 2, with tables anywhere. */
const OLD_JPEG = 6;
/** Bytes of a value by its type. */
const SIZES = [0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4];
const [SHORT, LONG] = [3, 4];
const FIELD = 12;
/** Pictures in a file; a scanned book has hundreds. */
const MOST_DIRECTORIES = 4096;
/** Maximum number of fields, strips and tiles. Overlaps could make millions of them. */
const MOST_PIECES = 2 ** 20;

/**
 * @param bytes of a file; changed
 * @returns null if the file is incomplete, or its pixels need fields that are not allowed. `clean`: false if pixels and
 *   metadata share bytes
 */
export function tiffParts(bytes: Uint8Array<ArrayBuffer>): { parts: BlobPart[]; clean: boolean } | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const little = bytes[0] === 0x49;
  const directories = directoriesOf(view, little);
  if (!directories) return null;
  // Reduced copies may show parts that were cropped from the picture. The first directory is the picture that programs
  // open.
  const pictures = directories.filter(({ fields }, i) => i === 0 || !(numberOf(view, little, fields, KIND) & REDUCED));

  const pixels: Range[] = [];
  const values: Range[] = [];
  /** Metadata ranges. */
  const gone: Range[] = [];
  const all: Range[] = directories.map(({ place, end }) => [place, end + 4]);
  for (const directory of directories) {
    const { fields } = directory;
    const stays = pictures.includes(directory);
    for (const { tag, at, length } of fields)
      if (length > 4) (stays && NEEDED.has(tag) ? values : gone).push([at, at + length]);
    if (!stays) continue;
    if (
      fields.some(({ tag }) => tag === DNG) ||
      numberOf(view, little, fields, COMPRESSION) === OLD_JPEG ||
      hasFullSize(view, little, fields)
    )
      return null;
    for (const [places, lengths] of PIXELS) {
      const [from, long] = [places, lengths].map((tag) => numbersOf(view, little, fields, tag));
      if (from.length !== long.length || pixels.length + from.length > MOST_PIECES) return null;
      from.forEach((at, i) => pixels.push([at, at + long[i]]));
    }
  }
  const tables = pictures.map(
    ({ place, fields }) => [place, place + 2 + FIELD * fields.filter(isNeeded).length + 4] as Range,
  );
  const kept = joined([[0, 8], ...pixels, ...values, ...tables]);
  const end = kept[kept.length - 1][1];
  // The last table may be truncated after its fields.
  if (
    pixels.length === 0 ||
    joined([...pixels, ...values]).some(([, to]) => to > bytes.length) ||
    meet([...pixels, ...values], all)
  )
    return null;

  const made = pictures.map((directory, i) => tableOf(view, little, directory, pictures[i + 1]?.place ?? 0));
  const clean = !meet([...pixels, ...values], gone);
  const whole = bytes.length < end ? grown(bytes, end) : bytes.subarray(0, end);
  blankAround(whole, kept);
  pictures.forEach(({ place }, i) => whole.set(made[i], place));
  return { parts: [whole], clean };
}

/** @returns the same data, without anything after it */
function grown(bytes: Uint8Array, length: number): Uint8Array<ArrayBuffer> {
  const longer = new Uint8Array(length);
  longer.set(bytes);
  return longer;
}

const isNeeded = ({ tag }: Field) => NEEDED.has(tag);

/** @returns its preserved fields */
function tableOf(view: DataView, little: boolean, { fields }: Directory, next: number): Uint8Array<ArrayBuffer> {
  const kept = fields.filter(isNeeded);
  const table = new Uint8Array(2 + FIELD * kept.length + 4);
  const to = new DataView(table.buffer);
  to.setUint16(0, kept.length, little);
  kept.forEach(({ tag, type, count, at, length }, i) => {
    const field = 2 + FIELD * i;
    to.setUint16(field, tag, little);
    to.setUint16(field + 2, type, little);
    to.setUint32(field + 4, count, little);
    if (length > 4) to.setUint32(field + 8, at, little);
    // A short value leaves bytes of the field over.
    else for (let j = 0; j < length; j += 1) to.setUint8(field + 8 + j, view.getUint8(at + j));
  });
  to.setUint32(2 + FIELD * kept.length, next, little);
  return table;
}

/** @returns the directories of the images in sequence; null if they are incomplete */
function directoriesOf(view: DataView, little: boolean): Directory[] | null {
  const found: Map<number, Directory> = new Map();
  let pieces = 0;
  for (let at = view.byteLength < 8 ? 0 : view.getUint32(4, little); at !== 0; ) {
    const directory = found.has(at) || found.size === MOST_DIRECTORIES ? null : directoryAt(view, little, at);
    pieces += directory?.fields.length ?? 0;
    if (!directory || pieces > MOST_PIECES) return null;
    found.set(at, directory);
    at = directory.next;
  }
  return found.size === 0 ? null : [...found.values()];
}

/** @returns null if it is truncated */
function directoryAt(view: DataView, little: boolean, place: number): Directory | null {
  if (place < 8 || place + 2 > view.byteLength) return null;
  const end = place + 2 + FIELD * view.getUint16(place, little);
  if (end > view.byteLength) return null;
  const fields: Map<number, Field> = new Map();
  for (let field = place + 2; field < end; field += FIELD) {
    const [tag, type, count] = [
      view.getUint16(field, little),
      view.getUint16(field + 2, little),
      view.getUint32(field + 4, little),
    ];
    const length = count * (SIZES[type] ?? 1);
    const at = length > 4 ? view.getUint32(field + 8, little) : field + 8;
    // Said twice, the first holds.
    if (!fields.has(tag)) fields.set(tag, { tag, type, count, at, length });
  }
  // Some writers leave out the end of the last one.
  return {
    place,
    end,
    fields: [...fields.values()],
    next: end + 4 <= view.byteLength ? view.getUint32(end, little) : 0,
  };
}

/** @returns empty if the tag is missing or not a list of numbers */
function numbersOf(view: DataView, little: boolean, fields: readonly Field[], tag: number): number[] {
  const field = fields.find((other) => other.tag === tag);
  if (!field || ![SHORT, LONG].includes(field.type) || field.at + field.length > view.byteLength) return [];
  const { type, count, at } = field;
  return Array.from({ length: count }, (_, i) =>
    type === SHORT ? view.getUint16(at + 2 * i, little) : view.getUint32(at + 4 * i, little),
  );
}

/** @returns 0 if the tag is missing */
function numberOf(view: DataView, little: boolean, fields: readonly Field[], tag: number): number {
  return numbersOf(view, little, fields, tag)[0] ?? 0;
}

/**
 * Camera files (DNG, NEF) have a small picture first. The large one after it needs tags that the allowlist does not
 * contain.
 */
function hasFullSize(view: DataView, little: boolean, fields: readonly Field[]) {
  return numbersOf(view, little, fields, SUB_DIRECTORIES).some((place) => {
    const inner = directoryAt(view, little, place);
    return inner !== null && !(numberOf(view, little, inner.fields, KIND) & REDUCED);
  });
}
