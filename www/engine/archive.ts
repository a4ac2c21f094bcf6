/**
 * ZIP files without copies. New files are stored uncompressed, because photos are already compressed, and files are
 * read as slices of the archive. Layout of the records after PKWARE's APPNOTE 6.3.3, sections 4.3.7, 4.3.12 and 4.3.16.
 *
 * Measured with 75 photos of 4 MB, libraries were worse. zip.js copies all stored data: 650 MB more memory for writing,
 * compared with 20 MB here. It has 53 kB gzipped, and this module has 2. fflate (6 kB) takes complete arrays and reads
 * without the central directory.
 */

import { archiveNames } from './archive-names.ts';
import { crcOf } from './crc.ts';
import { inflated, roomFor } from './inflate.ts';
import { ARCHIVE } from './limits.ts';
import { damaged, failure } from './protocol.ts';
import type { Watch } from './inflate.ts';

type Entry = { name: string; blob: Blob };
/** How long work is followed and stopped. */
export type Work = { signal?: AbortSignal; onProgress?: (done: number, total: number) => void };
/**
 * A file in it. `packed`: compressed, so reading it takes memory. `read` rejects with `damaged-project` if the checksum
 * does not match, with `too-large-project` if the size exceeds `most` or a limit.
 */
type Found = { name: string; packed: boolean; read: (how?: { most?: number } & Watch) => Promise<Blob> };
/** Fields of a file in the central directory; `end` is the offset of the directory. */
type Told = {
  name: Uint8Array;
  flags: number;
  method: number;
  crc: number;
  length: number;
  size: number;
  offset: number;
  end: number;
};

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const [LOCAL_SIZE, CENTRAL_SIZE, END_SIZE] = [30, 46, 22];
/** Maximum length of the comment at the end of a file. */
const MOST_COMMENT = 0xffff;
const MOST_BYTES = 0xffffffff;
/** Marks a number that is too large for its field, in ZIP64 files. */
const [ELSEWHERE_SHORT, ELSEWHERE] = [0xffff, 0xffffffff];
/** Names are UTF-8. */
const UTF8 = 0x0800;
const ENCRYPTED = 1;
/** The length follows after the file. */
const LATER = 8;
const [STORED, DEFLATED] = [0, 8];

/**
 * @param how `onProgress` gets the number of files with a computed checksum
 * @returns rejects with `too-large` above four gigabytes, because no program could open the file
 */
export async function archiveOf(entries: readonly Entry[], { signal, onProgress }: Work = {}): Promise<Blob> {
  if (entries.length > ARCHIVE.entries)
    throw failure('too-large', `The project has more than ${ARCHIVE.entries} photos.`);
  const parts: BlobPart[] = [];
  const directory: BlobPart[] = [];
  let at = 0;
  let length = 0;
  for (const [i, { name, blob }] of entries.entries()) {
    onProgress?.(i, entries.length);
    const bytes = new TextEncoder().encode(name);
    const [crc, offset] = [await crcOf(blob, { signal }), at];
    // The time is always 1980-01-01, for privacy.
    const about = [20, UTF8, STORED, 0, 0x21];
    const local = record(LOCAL_SIZE, LOCAL, about, [crc, blob.size, blob.size], [bytes.length, 0]);
    const central = record(
      CENTRAL_SIZE,
      CENTRAL,
      [20, ...about],
      [crc, blob.size, blob.size],
      [bytes.length, 0, 0, 0, 0],
    );
    central.setUint32(42, offset, true);
    parts.push(local, bytes, blob);
    directory.push(central, bytes);
    at += LOCAL_SIZE + bytes.length + blob.size;
    length += CENTRAL_SIZE + bytes.length;
  }
  if (at + length > MOST_BYTES) throw failure('too-large-archive', 'The file would be larger than 4 GB.');
  const end = new DataView(new ArrayBuffer(END_SIZE));
  end.setUint32(0, END, true);
  end.setUint16(8, entries.length, true);
  end.setUint16(10, entries.length, true);
  end.setUint32(12, length, true);
  end.setUint32(16, at, true);
  return new Blob([...parts, ...directory, end]);
}

/** @param more shorts again */
function record(size: number, signature: number, shorts: number[], longs: number[], more: number[]) {
  const view = new DataView(new ArrayBuffer(size));
  view.setUint32(0, signature, true);
  let at = 4;
  for (const value of shorts) {
    view.setUint16(at, value, true);
    at += 2;
  }
  for (const value of longs) {
    view.setUint32(at, value, true);
    at += 4;
  }
  for (const value of more) {
    view.setUint16(at, value, true);
    at += 2;
  }
  return view;
}

/**
 * Reads the files of an archive. The archive is untrusted: each file must be in the central directory, have separate
 * bytes and a matching local header. The unpacked sizes are counted during unpacking, per file and in total.
 * @returns by name. Rejects with `damaged-project` if it is not a ZIP file or a ZIP64 file; with `too-large-project` if
 *   the actual or stated size exceeds a limit
 */
export async function readArchive(file: Blob): Promise<Map<string, Found>> {
  const told = await listOf(file);
  const packed = told.filter(({ method }) => method !== STORED);
  const most = ARCHIVE.unpacked(file.size);
  if (packed.some(({ size }) => size > ARCHIVE.entry) || packed.reduce((sum, { size }) => sum + size, 0) > most)
    throw tooLarge();
  /** Total unpacked size. */
  const room = roomFor(most);
  const found: Map<string, Found> = new Map();
  const names = await archiveNames(told.map(({ name }) => name));
  const seen = new Set() as Set<string>;
  for (const [i, entry] of told.entries()) {
    const name = names[i];
    const key = String.fromCharCode(...entry.name);
    if (seen.has(key)) throw damaged(`${name} is in it twice`);
    seen.add(key);
    found.set(name, {
      name,
      packed: entry.method !== STORED,
      read: (how = {}) => readEntry(file, entry, { name, room, ...how }),
    });
  }
  return found;
}

/** @returns in the order of the list */
async function listOf(file: Blob): Promise<Told[]> {
  const tailAt = Math.max(0, file.size - END_SIZE - MOST_COMMENT);
  const tail = await viewOf(file.slice(tailAt));
  let at = tail.byteLength - END_SIZE;
  while (at >= 0 && tail.getUint32(at, true) !== END) at -= 1;
  if (at < 0) throw damaged('it is truncated');
  const [disk, listDisk, here, count] = [4, 6, 8, 10].map((field) => tail.getUint16(at + field, true));
  const [length, start] = [12, 16].map((field) => tail.getUint32(at + field, true));
  if (count === ELSEWHERE_SHORT || length === ELSEWHERE || start === ELSEWHERE) throw damaged('ZIP64 is not supported');
  if (disk !== 0 || listDisk !== 0 || here !== count) throw damaged('multi-part ZIP archives are not supported');
  if (start + length > tailAt + at || length < count * CENTRAL_SIZE) throw damaged('its list of files is missing');
  if (count > ARCHIVE.entries || length > ARCHIVE.directory) throw tooLarge();
  const list = await viewOf(file.slice(start, start + length));
  const told: Told[] = [];
  let from = 0;
  for (let i = 0; i < count; i += 1) {
    if (from + CENTRAL_SIZE > length || list.getUint32(from, true) !== CENTRAL)
      throw damaged('its list of files is broken');
    const [flags, method, nameLength, extra, comment] = [8, 10, 28, 30, 32].map((field) =>
      list.getUint16(from + field, true),
    );
    const next = from + CENTRAL_SIZE + nameLength + extra + comment;
    if (next > length) throw damaged('its list of files is broken');
    if (nameLength > ARCHIVE.name) throw tooLarge();
    const [crc, packed, size, offset] = [16, 20, 24, 42].map((field) => list.getUint32(from + field, true));
    const name = new Uint8Array(list.buffer, from + CENTRAL_SIZE, nameLength);
    told.push({ name, flags, method, crc, length: packed, size, offset, end: start });
    from = next;
  }
  if (from !== length) throw damaged('its list of files is broken');
  // Each ends before the next one begins, and the last before the list.
  const inOrder = [...told].sort((one, other) => one.offset - other.offset);
  inOrder.forEach((entry, i) => {
    entry.end = inOrder[i + 1]?.offset ?? start;
    if (entry.offset + LOCAL_SIZE + entry.name.length + entry.length > entry.end)
      throw damaged('two of its files are one');
  });
  return told;
}

async function readEntry(
  file: Blob,
  entry: Told,
  {
    name,
    room,
    most = Infinity,
    signal,
    beat,
  }: { name: string; room: (bytes: number) => boolean; most?: number } & Watch,
) {
  const { flags, method, crc, length, size, offset, end } = entry;
  if (size > most) throw tooLarge();
  const local = await viewOf(file.slice(offset, offset + LOCAL_SIZE + entry.name.length));
  const start = offset + LOCAL_SIZE + local.getUint16(26, true) + local.getUint16(28, true);
  if (!agrees(local, entry) || start + length > end) throw damaged(`${name}: local and central headers disagree`);
  if (flags & ENCRYPTED || ![STORED, DEFLATED].includes(method))
    throw damaged(`${name} uses an unknown compression method`);
  const raw = file.slice(start, start + length);
  const blob = method === STORED ? raw : await unpacked(raw, size, { name, room, signal, beat });
  if (blob.size !== size || (await crcOf(blob, { signal, beat })) !== crc) throw damaged(`${name} is damaged`);
  return blob;
}

/**
 * @param local the head of a file
 * @returns whether the local header matches the central directory
 */
function agrees(local: DataView, { name, flags, method, crc, length, size }: Told): boolean {
  const [flagsHere, methodHere, nameLength] = [6, 8, 26].map((field) => local.getUint16(field, true));
  const numbers = [
    [14, crc],
    [18, length],
    [22, size],
  ] as const;
  const same = numbers.every(([field, number]) => {
    const here = local.getUint32(field, true);
    return here === number || (here === 0 && (flagsHere & LATER) !== 0) || (here === ELSEWHERE && field !== 14);
  });
  return (
    same &&
    local.getUint32(0, true) === LOCAL &&
    methodHere === method &&
    (flagsHere & ENCRYPTED) === (flags & ENCRYPTED) &&
    nameLength === name.length &&
    name.every((byte, i) => local.getUint8(LOCAL_SIZE + i) === byte)
  );
}

/** Unpacks a compressed file. */
async function unpacked(
  raw: Blob,
  size: number,
  { name, room, ...watch }: { name: string; room: (bytes: number) => boolean } & Watch,
) {
  const own = roomFor(size);
  let more = false;
  /** More data than stated means a damaged file. */
  const take = (bytes: number) => room(bytes) && !(more = !own(bytes));
  try {
    return await inflated(raw, 'deflate-raw', { take, ...watch });
  } catch (error) {
    const { code } = error as { code?: string };
    if (code === 'too-large' && !more) throw tooLarge();
    throw code === 'damaged' || more ? damaged(`${name} is damaged`) : error;
  }
}

function tooLarge() {
  return failure('too-large-project', 'It exceeds the limits of a project.');
}

async function viewOf(blob: Blob) {
  return new DataView(await blob.arrayBuffer());
}
