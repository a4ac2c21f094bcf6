// @ts-check
/**
 * ZIP files without copies: what is put in is stored as it is, as photos are compressed already, and what is read is a
 * slice of the file. Layout of the records after PKWARE's APPNOTE 6.3.3, sections 4.3.7, 4.3.12 and 4.3.16.
 */

import { damaged } from './versions.js';
import { crcOf } from '../../engine/crc.js';
import { failure } from '../../engine/protocol.js';

/** @typedef {{ name: string, blob: Blob }} Entry */
/** @typedef {{ name: string, read: () => Promise<Blob> }} Found */

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const [LOCAL_SIZE, CENTRAL_SIZE, END_SIZE] = [30, 46, 22];
/** The end of a file can have a comment of at most so many bytes. */
const MOST_COMMENT = 0xffff;
const MOST_ENTRIES = 0xffff;
const MOST_BYTES = 0xffffffff;
/** Names are UTF-8. */
const UTF8 = 0x0800;
const ENCRYPTED = 1;
const [STORED, DEFLATED] = [0, 8];

/**
 * @param {readonly Entry[]} entries
 * @returns {Promise<Blob>} rejects with `too-large` above four gigabytes
 */
export async function archiveOf(entries) {
  /** @type {BlobPart[]} */
  const parts = [];
  /** @type {BlobPart[]} */
  const directory = [];
  let at = 0;
  let length = 0;
  for (const { name, blob } of entries) {
    const bytes = new TextEncoder().encode(name);
    const [crc, offset] = [await crcOf(blob), at];
    // The time is 1980-01-01: when a file was made is nobody's business.
    const about = [20, UTF8, STORED, 0, 0x21];
    const local = record(LOCAL_SIZE, LOCAL, about, [crc, blob.size, blob.size], [bytes.length, 0]);
    const central = record(CENTRAL_SIZE, CENTRAL, [20, ...about], [crc, blob.size, blob.size], [bytes.length, 0, 0, 0, 0]);
    central.setUint32(42, offset, true);
    parts.push(local, bytes, blob);
    directory.push(central, bytes);
    at += LOCAL_SIZE + bytes.length + blob.size;
    length += CENTRAL_SIZE + bytes.length;
  }
  if (entries.length > MOST_ENTRIES || at + length > MOST_BYTES) throw failure('too-large', 'The file would be larger than 4 GB.');
  const end = new DataView(new ArrayBuffer(END_SIZE));
  end.setUint32(0, END, true);
  end.setUint16(8, entries.length, true);
  end.setUint16(10, entries.length, true);
  end.setUint32(12, length, true);
  end.setUint32(16, at, true);
  return new Blob([...parts, ...directory, end]);
}

/**
 * @param {number} size
 * @param {number} signature
 * @param {number[]} shorts
 * @param {number[]} longs
 * @param {number[]} more shorts again
 */
function record(size, signature, shorts, longs, more) {
  const view = new DataView(new ArrayBuffer(size));
  view.setUint32(0, signature, true);
  let at = 4;
  for (const value of shorts) { view.setUint16(at, value, true); at += 2; }
  for (const value of longs) { view.setUint32(at, value, true); at += 4; }
  for (const value of more) { view.setUint16(at, value, true); at += 2; }
  return view;
}

/**
 * @param {Blob} file
 * @returns {Promise<Map<string, Found>>} what is in it, by name; `read` rejects where the bytes are not those that were
 *   put in. Rejects with `damaged-project` where it is no ZIP file
 */
export async function readArchive(file) {
  const tail = await bytesOf(file.slice(-(END_SIZE + MOST_COMMENT)));
  let at = tail.byteLength - END_SIZE;
  while (at >= 0 && tail.getUint32(at, true) !== END) at -= 1;
  if (at < 0) throw damaged('its end is missing');
  const [count, length, start] = [tail.getUint16(at + 10, true), tail.getUint32(at + 12, true), tail.getUint32(at + 16, true)];
  if (start + length > file.size) throw damaged('its list of files is missing');
  const directory = await bytesOf(file.slice(start, start + length));
  /** @type {Map<string, Found>} */
  const found = new Map();
  let from = 0;
  for (let i = 0; i < count; i += 1) {
    if (from + CENTRAL_SIZE > length || directory.getUint32(from, true) !== CENTRAL) throw damaged('its list of files is broken');
    const [nameLength, extra, comment] = [28, 30, 32].map((field) => directory.getUint16(from + field, true));
    if (from + CENTRAL_SIZE + nameLength > length) throw damaged('its list of files is broken');
    const name = new TextDecoder().decode(new Uint8Array(directory.buffer, from + CENTRAL_SIZE, nameLength));
    const [flags, method] = [8, 10].map((field) => directory.getUint16(from + field, true));
    const [crc, packed, size, offset] = [16, 20, 24, 42].map((field) => directory.getUint32(from + field, true));
    found.set(name, { name, read: () => readEntry(file, { name, flags, method, crc, packed, size, offset }) });
    from += CENTRAL_SIZE + nameLength + extra + comment;
  }
  return found;
}

/**
 * @param {Blob} file
 * @param {{ name: string, flags: number, method: number, crc: number, packed: number, size: number, offset: number }} entry
 */
async function readEntry(file, { name, flags, method, crc, packed, size, offset }) {
  if (offset + LOCAL_SIZE > file.size) throw damaged(`${name} is missing`);
  const local = await bytesOf(file.slice(offset, offset + LOCAL_SIZE));
  if (local.getUint32(0, true) !== LOCAL || flags & ENCRYPTED) throw damaged(`${name} cannot be read`);
  const start = offset + LOCAL_SIZE + local.getUint16(26, true) + local.getUint16(28, true);
  if (start + packed > file.size) throw damaged(`${name} is cut short`);
  const raw = file.slice(start, start + packed);
  const blob = method === STORED ? raw : method === DEFLATED ? await inflated(raw, size, name) : null;
  if (!blob || blob.size !== size || await crcOf(blob) !== crc) throw damaged(`${name} is damaged`);
  return blob;
}

/**
 * What another program has packed.
 * @param {Blob} raw
 * @param {number} size
 * @param {string} name
 */
async function inflated(raw, size, name) {
  const reader = raw.stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
  /** @type {BlobPart[]} */
  const parts = [];
  let length = 0;
  for (;;) {
    const { value, done } = await reader.read().catch(() => { throw damaged(`${name} is damaged`); });
    if (done) return new Blob(parts);
    length += value.length;
    // It unpacks to more than it says: whatever it is, it is no photo.
    if (length > size) throw damaged(`${name} is damaged`);
    parts.push(value);
  }
}

/** @param {Blob} blob */
async function bytesOf(blob) {
  return new DataView(await blob.arrayBuffer());
}
