/**
 * Reads and inserts chunks of a PNG file without decoding it. Results are slices of the file, so large files are never
 * copied. Source: PNG Specification (Third Edition), sections 5 and 11.3.3.
 */

import { crcOf } from './crc.ts';
import { inflated, roomFor } from './inflate.ts';
import { PNG } from './limits.ts';

/** A chunk: `at` is the start of its data, `length` its size in bytes. */
export type Chunk = { type: string; at: number; length: number };

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
/** Length and type before the data, CRC after it. */
const [HEAD, FOOT] = [8, 4];
const MOST_LENGTH = 2 ** 31 - 1;
/** Bytes that are read at once, because many chunks are small. */
const WINDOW = 2 ** 16;

/** @returns by its content, whatever it is called */
export async function isPng(file: Blob): Promise<boolean> {
  const start = new Uint8Array(await file.slice(0, SIGNATURE.length).arrayBuffer());
  return SIGNATURE.every((byte, i) => start[i] === byte);
}

/**
 * @param file that is a PNG
 * @returns all chunks; null if the file is incomplete
 */
export async function chunksOf(file: Blob): Promise<Chunk[] | null> {
  const chunks: Chunk[] = [];
  let from = 0;
  let view = new DataView(new ArrayBuffer(0));
  for (let at = SIGNATURE.length; at + HEAD + FOOT <= file.size; ) {
    if (at + HEAD > from + view.byteLength) {
      from = at;
      view = new DataView(await file.slice(at, at + WINDOW).arrayBuffer());
    }
    const length = view.getUint32(at - from);
    const type = String.fromCharCode(...[4, 5, 6, 7].map((i) => view.getUint8(at - from + i)));
    const chunk = { type, at: at + HEAD, length };
    at += HEAD + length + FOOT;
    if (length > MOST_LENGTH || at > file.size || chunks.length === PNG.chunks || !/^[A-Za-z]{4}$/.test(type))
      return null;
    chunks.push(chunk);
    if (type === 'IEND') return chunks;
  }
  return null;
}

/** @returns with its length, type and CRC */
export function wholeChunk(file: Blob, { at, length }: Chunk): Blob {
  return file.slice(at - HEAD, at + length + FOOT);
}

/** @returns its data; null if the checksum does not match */
export async function dataOf(file: Blob, { at, length }: Chunk): Promise<Blob | null> {
  const foot = new DataView(await file.slice(at + length, at + length + FOOT).arrayBuffer());
  return (await crcOf(file.slice(at - 4, at + length))) === foot.getUint32(0) ? file.slice(at, at + length) : null;
}

/**
 * @param type four characters
 * @param data below 2 GB
 * @returns a chunk
 */
export async function chunkOf(type: string, data: Blob | Uint8Array<ArrayBuffer>): Promise<Blob> {
  const body = new Blob([type, data]);
  const [head, foot] = [new DataView(new ArrayBuffer(4)), new DataView(new ArrayBuffer(4))];
  head.setUint32(0, body.size - 4);
  foot.setUint32(0, await crcOf(body));
  return new Blob([head, body, foot]);
}

/** The file of some chunks. */
export function pngOf(chunks: readonly Blob[]): Blob {
  return new Blob([Uint8Array.from(SIGNATURE), ...chunks], { type: 'image/png' });
}

/**
 * @param file that is a PNG
 * @param more chunks to insert before and after the pixels
 * @returns the file, unchanged if it has no chunks
 */
export async function withChunks(
  file: Blob,
  { before = [], after = [] }: { before?: readonly Blob[]; after?: readonly Blob[] },
): Promise<Blob> {
  const chunks = await chunksOf(file);
  const pixels = chunks?.find(({ type }) => type === 'IDAT');
  const end = chunks?.at(-1);
  if (!pixels || !end) return file;
  const [first, last] = [pixels.at - HEAD, end.at - HEAD];
  return new Blob(
    [file.slice(0, first), ...before, file.slice(first, last), ...after, file.slice(last, end.at + FOOT)],
    { type: 'image/png' },
  );
}

/** @returns an `iTXt` chunk, deflated */
export async function textChunk(keyword: string, text: string): Promise<Blob> {
  const deflated = await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate'))).blob();
  // Keyword, end of it, deflated, by the one method, no language, no translation of the keyword.
  return chunkOf('iTXt', new Blob([keyword, Uint8Array.of(0, 1, 0, 0, 0), deflated]));
}

/** @param data of an `iTXt` chunk */
export async function textHead(data: Blob): Promise<{ keyword: string; deflated: boolean; body: Blob } | null> {
  const head = new Uint8Array(await data.slice(0, PNG.textHead).arrayBuffer());
  const keyword = head.indexOf(0);
  const language = keyword < 0 ? -1 : head.indexOf(0, keyword + 3);
  const end = language < 0 ? -1 : head.indexOf(0, language + 1);
  if (end < 0 || head[keyword + 2] !== 0) return null;
  return {
    keyword: new TextDecoder('latin1').decode(head.subarray(0, keyword)),
    deflated: head[keyword + 1] === 1,
    body: data.slice(end + 1),
  };
}

/**
 * @param longest bytes that it may unpack to
 * @returns null if it is longer, or damaged
 */
export async function textOf(
  { deflated, body }: { deflated: boolean; body: Blob },
  longest: number,
): Promise<string | null> {
  if (!deflated) return body.size > longest ? null : body.text();
  try {
    // Larger text is malicious.
    return await (await inflated(body, 'deflate', { take: roomFor(longest) })).text();
  } catch {
    return null;
  }
}
