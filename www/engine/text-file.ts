/**
 * The text of files that users choose: tables, scripts, subtitles, layouts and styles. The browser decodes UTF-8; everything
 * else is decoded by the core (`crates/engine/src/texts.rs`).
 */

import { failure } from './protocol.ts';
import { textModule } from './text-module.ts';

/**
 * `encoding`: its name; `guessed`: whether it was guessed from the bytes; `lost`: number of places that are invalid in it,
 * which the text has as U+FFFD.
 */
export type DecodedText = { text: string; encoding: string; guessed: boolean; lost: number };

/** Characters of UTF-16, of ISO-2022-JP and of binary files. */
const SPECIAL = ['\0', '\u001b'] as const;

/**
 * Decodes UTF-8, UTF-16 and UTF-32 with and without a byte order mark, or a guessed encoding. The byte order mark is
 * removed.
 * @param encoding its name, if the user chose one
 * @returns null for bytes that are not text
 */
export async function decodeText(bytes: Uint8Array, encoding = ''): Promise<DecodedText | null> {
  const plain = encoding === '' ? utf8(bytes) : null;
  if (plain !== null) return { text: plain, encoding: 'UTF-8', guessed: false, lost: 0 };
  const { decode } = await textModule();
  const read = decode(bytes, userLanguage(), encoding);
  if (!read) return null;
  const decoded = { text: read.text, encoding: read.encoding, guessed: read.guessed, lost: read.lost };
  read.free();
  return decoded;
}

/** Decodes the names in an archive together, because they have one encoding. */
export async function decodeNames(names: readonly Uint8Array[]): Promise<string[]> {
  const plain = names.map(utf8);
  if (plain.every((name) => name !== null)) return plain;
  const bytes = Uint8Array.from(names.flatMap((name) => [...name]));
  let end = 0;
  const ends = names.map((name) => (end += name.length));
  return (await textModule()).names(bytes, Uint32Array.from(ends), userLanguage());
}

/** Reads a text file. Throws `not-text` for bytes that are not text, or the error of the browser for an unreadable file. */
export async function readText(file: Blob, encoding = ''): Promise<DecodedText> {
  const decoded = await decodeText(new Uint8Array(await file.arrayBuffer()), encoding);
  if (!decoded) throw failure('not-text', 'The file is not text.');
  return decoded;
}

function utf8(bytes: Uint8Array): string | null {
  try {
    const text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    return SPECIAL.some((character) => text.includes(character)) ? null : text;
  } catch {
    return null;
  }
}

/** The language of the user, which decides between encodings that fit equally well. */
function userLanguage(): string {
  return globalThis.navigator?.language ?? '';
}
