/**
 * Removes metadata from boxes, the containers of videos (MP4, QuickTime) and some photos (HEIC, AVIF). Positions in
 * such a file are absolute, so metadata is blanked in place. Sources: ISO/IEC 14496-12; QuickTime File Format.
 */

/** `start` is the start of the box, `inner` the start of its content. */
export type Box = { type: string; start: number; inner: number; end: number };

/** Boxes that hold others. */
const NESTED = new Set([
  'moov',
  'trak',
  'mdia',
  'minf',
  'dinf',
  'stbl',
  'edts',
  'mvex',
  'moof',
  'traf',
  'mfra',
  'tapt',
]);
/** Boxes with positions, durations and codecs of pictures and sounds. */
const NEEDED = new Set([
  'mvhd',
  'tkhd',
  'mdhd',
  'hdlr',
  'vmhd',
  'smhd',
  'nmhd',
  'gmhd',
  'dref',
  'elst',
  'tref',
  'clef',
  'prof',
  'enof',
  'mehd',
  'trex',
  'leva',
  'stsd',
  'stts',
  'ctts',
  'cslg',
  'stss',
  'stsh',
  'stsc',
  'stsz',
  'stz2',
  'stco',
  'co64',
  'sdtp',
  'sbgp',
  'sgpd',
  'subs',
  'padb',
  'stdp',
  'stps',
  'saiz',
  'saio',
  'mfhd',
  'tfhd',
  'tfdt',
  'trun',
  'tfra',
  'mfro',
]);
/** Allowed boxes at the top level of a video. The content of the last three is removed. */
const AT_TOP = new Set(['ftyp', 'styp', 'sidx', 'ssix', 'mdat', 'free', 'skip', 'wide']);
const EMPTY = new Set(['free', 'skip', 'wide']);
/** Boxes that begin with when they were made and changed. */
const DATED = new Set(['mvhd', 'tkhd', 'mdhd']);
/** Tracks of video and sound. Others may contain places or times of day. */
const SEEN_OR_HEARD = new Set(['vide', 'auxv', 'pict', 'soun']);
const COMPRESSED = 'cmov';
/** In the head of how pictures are coded: who made the coder, and its name. */
const CODER = [
  [20, 24],
  [50, 82],
];
/** Maximum size of a part that is read completely. */
const MOST_BYTES = 256 * 2 ** 20;
/** Zeros that replace removed boxes, in chunks of this size. */
const NOTHING = new Uint8Array(2 ** 20);

/**
 * @param file a video
 * @returns `clean`: false if a track contains other data, which stays; null if the file is incomplete
 */
export async function filmParts(file: Blob): Promise<{ parts: BlobPart[]; clean: boolean } | null> {
  const parts: BlobPart[] = [];
  /** Number of boxes before the last visible data. */
  let last = 0;
  let clean = true;
  const seen = new Set();
  for (let at = 0; at < file.size; ) {
    const head = new DataView(await file.slice(at, at + 16).arrayBuffer());
    const box = boxAt(head, 0, file.size - at);
    if (!box) {
      // Data after a complete video is not part of it, unless it is a truncated box.
      const type = head.byteLength < 8 ? '' : typeAt(head, 4);
      if (!seen.has('moov') || !seen.has('mdat') || AT_TOP.has(type) || NESTED.has(type)) return null;
      break;
    }
    const { type, inner, end } = box;
    const part = file.slice(at, at + end);
    seen.add(type);
    if (NESTED.has(type)) {
      if (end > MOST_BYTES) return null;
      const bytes = new Uint8Array(await part.arrayBuffer());
      clean = scrubBoxes(bytes) && clean;
      parts.push(bytes);
      last = parts.length;
    } else if (AT_TOP.has(type) && !EMPTY.has(type)) {
      parts.push(part);
      last = parts.length;
    } else {
      const name = EMPTY.has(type) ? type : 'free';
      parts.push(part.slice(0, 4), name, part.slice(8, inner), ...nothing(end - inner));
    }
    at += end;
  }
  return { parts: parts.slice(0, last), clean };
}

/** @returns zero bytes that share one buffer */
function nothing(length: number): BlobPart[] {
  const whole = Array(Math.floor(length / NOTHING.length)).fill(NOTHING);
  return [...whole, NOTHING.subarray(0, length % NOTHING.length)];
}

export function typeAt(view: DataView, at: number) {
  return String.fromCharCode(...[0, 1, 2, 3].map((i) => view.getUint8(at + i)));
}

/**
 * @param room bytes until the end of the parent
 * @returns null if it is longer, or not a box
 */
export function boxAt(view: DataView, at: number, room: number): Box | null {
  if (at + 8 > view.byteLength || room < 8) return null;
  const short = view.getUint32(at);
  if (short === 1 && at + 16 > view.byteLength) return null;
  const [head, length] = short === 1 ? [16, Number(view.getBigUint64(at + 8))] : [8, short === 0 ? room : short];
  return length < head || length > room
    ? null
    : { type: typeAt(view, at + 4), start: at, inner: at + head, end: at + length };
}

/** @returns the boxes in sequence; null if there is other data between them */
export function boxesIn(view: DataView, from: number, to: number): Box[] | null {
  const found: Box[] = [];
  for (let at = from; at < to; ) {
    const box = boxAt(view, at, to - at);
    if (!box) return null;
    found.push(box);
    at = box.end;
  }
  return found;
}

/**
 * A box called `free` is passed over by every reader.
 * @param bytes are changed
 */
export function blankBox(bytes: Uint8Array, { start, inner, end }: Box) {
  bytes.set([0x66, 0x72, 0x65, 0x65], start + 4);
  bytes.fill(0, inner, end);
}

/**
 * @param bytes of boxes, one after the other; changed
 * @returns whether all metadata was removed
 */
export function scrubBoxes(bytes: Uint8Array): boolean {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  /** @param track kind of the track, if known */
  const scrub = (from: number, to: number, parent: string, track: string): boolean => {
    let at = from;
    let clean = true;
    const inside = boxesIn(view, from, to);
    // QuickTime ends a list of boxes with four zero bytes.
    const found = inside ?? boxesIn(view, from, to - 4);
    if (!found) return false;
    if (!inside) bytes.fill(0, to - 4, to);
    const told = parent === 'mdia' ? found.find(({ type }) => type === 'hdlr') : undefined;
    const kind = told && told.end - told.inner >= 12 ? typeAt(view, told.inner + 8) : track;
    if (told && !SEEN_OR_HEARD.has(kind)) clean = false;
    for (const box of found) {
      const { type, inner, end } = box;
      at = inner;
      if (NESTED.has(type)) clean = scrub(at, end, type, kind) && clean;
      else if (type === COMPRESSED) clean = false;
      else if (!NEEDED.has(type)) blankBox(bytes, box);
      else if (DATED.has(type)) bytes.fill(0, Math.min(end, at + 4), Math.min(end, at + (bytes[at] === 1 ? 20 : 12)));
      else if (type === 'hdlr') blankHandler(bytes, box);
      else if (type === 'dref') clean = scrubPlaces(bytes, view, box) && clean;
      else if (type === 'stsd' && kind !== 'soun') scrubCoders(bytes, view, box);
    }
    return clean;
  };
  return scrub(0, bytes.length, '', '');
}

/**
 * Blanks the name and the vendor. The handler type is preserved.
 * @param bytes are changed
 */
export function blankHandler(bytes: Uint8Array, { inner, end }: Box) {
  bytes.fill(0, Math.min(end, inner + 12), end);
}

/**
 * Removes file names from data references. Some writers store disk and folder names.
 * @param bytes are changed
 * @returns false if the data is in other files
 */
function scrubPlaces(bytes: Uint8Array, view: DataView, { inner, end }: Box): boolean {
  const places = boxesIn(view, inner + 8, end);
  if (!places) return false;
  for (const place of places) {
    if (place.end - place.inner < 4 || !(view.getUint32(place.inner) & 1)) return false;
    bytes.fill(0, place.inner + 4, place.end);
  }
  return true;
}

/** @param bytes are changed */
function scrubCoders(bytes: Uint8Array, view: DataView, { inner, end }: Box) {
  for (const { start, end: stop } of boxesIn(view, inner + 8, end) ?? []) {
    for (const [from, to] of CODER) bytes.fill(0, Math.min(stop, start + from), Math.min(stop, start + to));
  }
}
