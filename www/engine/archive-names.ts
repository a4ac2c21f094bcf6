/**
 * Names of files in a ZIP archive. Only names with a flag are certainly UTF-8. Other names have the encoding of the system that
 * wrote them: Shift-JIS in Japan, code page 437 elsewhere.
 */

/** Upper half of code page 437, from 0x80. */
const CP437 =
  'ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0';
/** Japanese letters of full width. Bytes of other encodings give letters of half width as well. */
const JAPANESE = /[\u3040-\u30ff\u4e00-\u9fff]/;

/**
 * @param names as bytes, which differ
 * @returns the names, which differ as well
 */
export function archiveNames(names: readonly Uint8Array[]): string[] {
  const utf8 = names.map((bytes) => decoded('utf-8', bytes));
  const others = names.filter((_, i) => utf8[i] === null);
  // One system wrote all names of an archive.
  const japanese = others.map((bytes) => decoded('shift_jis', bytes));
  const isJapanese = japanese.every((name) => name !== null) && japanese.some((name) => JAPANESE.test(name ?? ''));
  const plain = (bytes: Uint8Array) => (isJapanese ? (decoded('shift_jis', bytes) as string) : latin(bytes));
  const taken = new Set() as Set<string>;
  return names.map((bytes, i) => {
    const name = fresh(utf8[i] ?? plain(bytes), taken);
    taken.add(name);
    return name;
  });
}

/** @returns null if the bytes are not text in this encoding */
function decoded(encoding: string, bytes: Uint8Array): string | null {
  try {
    return new TextDecoder(encoding, { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return null;
  }
}

function latin(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => (byte < 0x80 ? String.fromCharCode(byte) : CP437[byte - 0x80])).join('');
}

/** Two names may be equal after decoding. @returns the name with a number before its ending, if it is taken */
function fresh(name: string, taken: ReadonlySet<string>): string {
  const [, stem, ending] = /^(.*?)(\.[^./\\]*)?$/s.exec(name) as RegExpExecArray;
  let unique = name;
  for (let number = 2; taken.has(unique); number += 1) unique = `${stem} (${number})${ending ?? ''}`;
  return unique;
}
