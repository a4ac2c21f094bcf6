/** Photos as files that the core reads, whatever they are. */

import { asBmp, foreignKind } from './foreign.ts';
import { converted, rareKind } from './rare.ts';
import { takenOf } from './taken.ts';

/** `format` and `taken` where the file that the core reads no longer says it. */
export type Readable = { file: Uint8Array<ArrayBuffer>; told: { format: string; taken: string | null } | null };

/**
 * @param bytes of a file
 * @throws with a `code`: what cannot be decoded
 */
export async function readable(bytes: Uint8Array<ArrayBuffer>): Promise<Readable> {
  const foreign = foreignKind(bytes);
  if (foreign) return { file: await asBmp(foreign, bytes), told: { format: foreign, taken: takenOf(bytes) } };
  const rare = rareKind(bytes);
  if (!rare) return { file: bytes, told: null };
  const { file, taken } = await converted(bytes);
  return { file, told: { format: rare, taken } };
}
