/**
 * The glyphs of the fonts: a separate file for the `words` and `exports` modules. It is compressed, because servers do
 * not compress unknown file types.
 */

import { moduleBytes } from './module-bytes.ts';
import { failure } from './protocol.ts';

const LETTERS = new URL('../letters/letters.bin', import.meta.url);

/** Error if the glyphs, or the module that draws them, could not be loaded. */
export const WORDS_MISSING = ['words-missing', 'The letters could not be loaded.'] as const;

/**
 * The table that a `Lettering` is made of.
 * @param told code and message of the error if the table cannot be loaded or is damaged
 */
export async function loadLetters([code, sentence]: readonly [string, string]): Promise<Uint8Array<ArrayBuffer>> {
  const packed = await moduleBytes(LETTERS, code, sentence);
  try {
    const table = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(table).arrayBuffer());
  } catch (cause) {
    throw Object.assign(failure(code, sentence), { cause });
  }
}
