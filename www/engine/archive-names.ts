/** Names of files in a ZIP archive. Only names with a flag are certainly UTF-8; the decoder of text files reads the others. */

import { decodeNames } from './text-file.ts';

/**
 * @param names as bytes, which differ
 * @returns the names, which differ as well
 */
export async function archiveNames(names: readonly Uint8Array[]): Promise<string[]> {
  // Without a connection, the decoder may be missing. The files can be read nevertheless.
  const decoded = await decodeNames(names).catch(() => names.map((name) => new TextDecoder().decode(name)));
  const taken = new Set() as Set<string>;
  return decoded.map((plain) => {
    const name = fresh(plain, taken);
    taken.add(name);
    return name;
  });
}

/** Two names may be equal after decoding. @returns the name with a number before its ending, if it is taken */
function fresh(name: string, taken: ReadonlySet<string>): string {
  const [, stem, ending] = /^(.*?)(\.[^./\\]*)?$/s.exec(name) as RegExpExecArray;
  let unique = name;
  for (let number = 2; taken.has(unique); number += 1) unique = `${stem} (${number})${ending ?? ''}`;
  return unique;
}
