/**
 * Removes metadata from photos in boxes (HEIC, AVIF). Such a file is a list of items. Images stay. Metadata items and
 * everything outside of items are blanked in place. The orientation in the camera record stays. Sources: ISO/IEC
 * 14496-12, 23008-12 (HEIF); AV1 Image File Format.
 */

import { blankBox, blankHandler, boxAt, boxesIn, scrubBoxes, typeAt } from './boxes.ts';
import { orientationOf, recordOf } from './exif.ts';
import { blankAround, meet } from './ranges.ts';
import type { Box } from './boxes.ts';
import type { Range } from './ranges.ts';

/** `name` is the position of its name, which ends with a zero byte. */
type Item = { type: string; name: Range };

/** Pictures, and what puts them together. */
const PICTURES = new Set([
  'hvc1',
  'hev1',
  'lhv1',
  'av01',
  'avc1',
  'vvc1',
  'evc1',
  'jpeg',
  'j2k1',
  'unci',
  'grid',
  'iovl',
  'iden',
  'tmap',
]);
const [EXIF, WORDS] = ['Exif', 'mime'];
/** Boxes about items: the primary image, locations, relations. */
const ABOUT = new Set(['hdlr', 'pitm', 'iinf', 'iloc', 'iprp', 'iref', 'idat', 'grpl', 'dinf']);
/** Properties that the pixels depend on: sides, coders, colours, turns. */
const PROPERTIES = new Set([
  'ispe',
  'pixi',
  'colr',
  'pasp',
  'clap',
  'irot',
  'imir',
  'auxC',
  'rloc',
  'clli',
  'mdcv',
  'cclv',
  'amve',
  'reve',
  'ndwt',
  'iscl',
  'tols',
  'oinf',
  'lsel',
  'hvcC',
  'lhvC',
  'av1C',
  'avcC',
  'vvcC',
  'evcC',
  'jpgC',
  'j2kH',
  'cmpd',
  'uncC',
  'a1op',
  'a1lx',
]);
/** Allowed boxes at the top level. The content of the last three is removed. */
const AT_TOP = new Set(['ftyp', 'meta', 'mdat', 'moov', 'moof', 'free', 'skip', 'wide']);
const [PICTURE_BOX, FILM] = ['mdat', new Set(['moov', 'moof'])];
const BLANK = 0x20;
/** Pieces of all items. */
const MOST_PIECES = 2 ** 20;

/**
 * @param bytes of a HEIC or AVIF file; changed
 * @returns null if the file is incomplete or of an unknown kind
 */
export function itemParts(bytes: Uint8Array<ArrayBuffer>): { parts: BlobPart[]; clean: boolean } | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const all = topOf(view);
  const meta = all.find(({ type }) => type === 'meta');
  const about = meta && boxesIn(view, meta.inner + 4, meta.end);
  if (!about) return null;
  const box = (type: string) => about.find((other) => other.type === type);
  const [infos, locations, data] = [box('iinf'), box('iloc'), box('idat')];
  if (!infos || !locations || infos.end - infos.inner < 8 || locations.end - locations.inner < 8) return null;
  const items = itemsOf(view, infos);
  const places = placesOf(view, locations, data?.inner ?? view.byteLength);
  if (!items || !places) return null;

  const last = all.findLastIndex(({ type }) => AT_TOP.has(type) && !['free', 'skip', 'wide'].includes(type));
  const whole = bytes.subarray(0, all[last].end);
  const pictures: Range[] = [];
  const records: { type: string; ranges: Range[] }[] = [];
  for (const [id, ranges] of places) {
    if (ranges.some(([, to]) => to > whole.length)) return null;
    const type = items.get(id)?.type ?? '';
    if (PICTURES.has(type)) pictures.push(...ranges);
    else records.push({ type, ranges });
  }
  let clean = !meet(
    pictures,
    records.flatMap(({ ranges }) => ranges),
  );
  if (clean) for (const { type, ranges } of records) blankRecord(whole, type, ranges);
  for (const {
    type,
    name: [from, to],
  } of items.values())
    whole.fill(PICTURES.has(type) || type === EXIF ? 0 : BLANK, from, to);

  const moves = all.some(({ type }) => FILM.has(type));
  for (const other of all.slice(0, last + 1)) {
    const { type, start, inner, end } = other;
    if (FILM.has(type)) clean = scrubBoxes(whole.subarray(start, end)) && clean;
    // The positions of video frames among other data are not known.
    else if (type === PICTURE_BOX && !moves)
      blankAround(whole, [...pictures, ...records.flatMap(({ ranges }) => ranges)], [inner, end]);
    else if (!AT_TOP.has(type)) blankBox(whole, other);
    else if (['free', 'skip', 'wide'].includes(type)) whole.fill(0, inner, end);
  }
  for (const other of about) {
    if (!ABOUT.has(other.type)) blankBox(whole, other);
    else if (other.type === 'hdlr') blankHandler(whole, other);
    else if (other.type === 'iprp') scrubProperties(whole, view, other);
    else if (other.type === 'dinf') clean = scrubBoxes(whole.subarray(other.start, other.end)) && clean;
    else if (other.type === 'idat')
      blankAround(whole, [...pictures, ...records.flatMap(({ ranges }) => ranges)], [other.inner, other.end]);
  }
  return { parts: [whole], clean };
}

/** @returns the boxes of the file, up to the first invalid one */
function topOf(view: DataView): Box[] {
  const found: Box[] = [];
  for (let at = 0; ; ) {
    const box = boxAt(view, at, view.byteLength - at);
    if (!box) return found;
    found.push(box);
    at = box.end;
  }
}

/** @returns by id; null for an unknown format of the list */
function itemsOf(view: DataView, { inner, end }: Box): Map<number, Item> | null {
  const entries = boxesIn(view, inner + (view.getUint8(inner) === 0 ? 6 : 8), end);
  const items: Map<number, Item> = new Map();
  for (const { type, inner: from, end: to } of entries ?? []) {
    const version = type === 'infe' && to - from >= 12 ? view.getUint8(from) : 0;
    const typed = from + (version === 3 ? 10 : 8);
    if (version < 2 || version > 3 || typed + 4 > to) return null;
    let stop = typed + 4;
    while (stop < to && view.getUint8(stop) !== 0) stop += 1;
    items.set(version === 3 ? view.getUint32(from + 4) : view.getUint16(from + 4), {
      type: typeAt(view, typed),
      name: [typed + 4, stop],
    });
  }
  return entries && items;
}

/**
 * @param data start of items inside the list itself
 * @returns by id; null for items in other files, or an unknown format of the list
 */
function placesOf(view: DataView, { inner, end }: Box, data: number): Map<number, Range[]> | null {
  const version = view.getUint8(inner);
  if (version > 2 || end > view.byteLength) return null;
  let at = inner + 6;
  /** @param size in bytes */
  const number = (size: number) => {
    at += size;
    if (at > end) throw new RangeError('cut short');
    if (size === 8) return Number(view.getBigUint64(at - 8));
    return size === 4 ? view.getUint32(at - 4) : size === 2 ? view.getUint16(at - 2) : 0;
  };
  const sizes = [
    view.getUint8(inner + 4) >> 4,
    view.getUint8(inner + 4) & 15,
    view.getUint8(inner + 5) >> 4,
    version > 0 ? view.getUint8(inner + 5) & 15 : 0,
  ];
  if (sizes.some((size) => ![0, 4, 8].includes(size))) return null;
  const [offset, length, base, index] = sizes;
  const places: Map<number, Range[]> = new Map();
  try {
    for (let left = number(version === 2 ? 4 : 2), pieces = 0; left > 0; left -= 1) {
      const id = number(version === 2 ? 4 : 2);
      const way = version > 0 ? number(2) & 15 : 0;
      if (number(2) !== 0 || way > 1) return null;
      const from = number(base) + (way === 1 ? data : 0);
      const ranges = places.get(id) ?? [];
      for (let extents = number(2); extents > 0; extents -= 1, pieces += 1) {
        number(index);
        const start = from + number(offset);
        const long = number(length);
        // To the end, wherever that is.
        if (long === 0 || pieces > MOST_PIECES) return null;
        ranges.push([start, start + long]);
      }
      places.set(id, ranges);
    }
  } catch {
    return null;
  }
  return places;
}

/**
 * @param bytes are changed
 * @param type of the item
 * @param ranges its positions
 */
function blankRecord(bytes: Uint8Array, type: string, ranges: readonly Range[]) {
  const before = new Uint8Array(ranges.reduce((sum, [from, to]) => sum + to - from, 0));
  let at = 0;
  for (const [from, to] of ranges) {
    before.set(bytes.subarray(from, to), at);
    at += to - from;
  }
  const after = new Uint8Array(before.length).fill(type === WORDS ? BLANK : 0);
  if (type === EXIF && before.length >= 4) {
    // A field before the record contains its offset, which is 0 now.
    const record = recordOf(
      orientationOf(before.subarray(Math.min(before.length, 4 + new DataView(before.buffer).getUint32(0)))),
    );
    if (4 + record.length <= after.length) after.set(record, 4);
  }
  at = 0;
  for (const [from, to] of ranges) {
    bytes.set(after.subarray(at, at + to - from), from);
    at += to - from;
  }
}

/** @param bytes are changed */
function scrubProperties(bytes: Uint8Array, view: DataView, { inner, end }: Box) {
  for (const box of boxesIn(view, inner, end) ?? []) {
    if (box.type === 'ipma') continue;
    const properties = box.type === 'ipco' ? boxesIn(view, box.inner, box.end) : null;
    if (!properties) blankBox(bytes, box);
    // Properties are referenced by index, so a removed one leaves its place.
    for (const property of properties ?? []) if (!PROPERTIES.has(property.type)) blankBox(bytes, property);
  }
}
