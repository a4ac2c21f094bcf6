/** The text of files that users choose: the one decoder for tables, scripts, subtitles, layouts and styles. */

import { failure } from './protocol.ts';

/** `guessed`: the bytes are not valid Unicode and were read as Windows-1252. */
export type DecodedText = { text: string; guessed: boolean };

/** The characters of Windows-1252 from 0x80 to 0x9f, which some versions of Node.js decode as control characters. */
const HIGH = '€\x81‚ƒ„…†‡ˆ‰Š‹Œ\x8dŽ\x8f\x90‘’“”•–—˜™š›œ\x9džŸ';

/**
 * Decodes UTF-8, UTF-16 with or without a byte order mark, or else Windows-1252. The byte order mark is removed.
 * @returns null for bytes that are not text
 */
export function decodeText(bytes: Uint8Array): DecodedText | null {
  const [first, second] = bytes;
  if (first === 0xff && second === 0xfe) return unicode(bytes, 'utf-16le');
  if (first === 0xfe && second === 0xff) return unicode(bytes, 'utf-16be');
  const utf8 = unicode(bytes, 'utf-8');
  if (utf8) return utf8;
  const zero = bytes.indexOf(0);
  // Every file in UTF-16 has line ends or spaces, whose high byte is 0: it comes second in little endian.
  if (zero >= 0) return unicode(bytes, zero % 2 === 1 ? 'utf-16le' : 'utf-16be', hasControls);
  const western = new TextDecoder('windows-1252').decode(bytes);
  const text = western.replace(/[\x80-\x9f]/g, (character) => HIGH[character.charCodeAt(0) - 0x80]);
  return hasControls(text) ? null : { text, guessed: true };
}

function unicode(bytes: Uint8Array, encoding: string, refused = hasZeros): DecodedText | null {
  try {
    const text = new TextDecoder(encoding, { fatal: true }).decode(bytes);
    return refused(text) ? null : { text, guessed: false };
  } catch {
    return null;
  }
}

function hasZeros(text: string): boolean {
  return text.includes('\0');
}

/** Whether a text has control characters of binary files; line ends, tabs, page breaks and the end mark of DOS are allowed. */
function hasControls(text: string): boolean {
  for (let i = 0; i < text.length; i += 1) {
    const code = text.charCodeAt(i);
    if (code === 0x7f || (code < 0x20 && code !== 0x1a && (code < 0x09 || code > 0x0d))) return true;
  }
  return false;
}

/** Reads a text file. Throws `not-text` for bytes that are not text, or the error of the browser for an unreadable file. */
export async function readText(file: Blob): Promise<DecodedText> {
  const decoded = decodeText(new Uint8Array(await file.arrayBuffer()));
  if (!decoded) throw failure('not-text', 'The file is not text.');
  return decoded;
}
