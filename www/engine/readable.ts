/** Photos as files that the core reads, whatever they are. */

import { asBmp, foreignKind } from './foreign.ts';
import { converted, rareKind } from './rare.ts';
import { taken_in_boxes } from '../pkg/inkpanel.js';
import type { Damage } from './types.ts';

/** Properties that a converted file no longer has; empty for an unconverted file. */
type Told = { format?: string; taken?: string | null; damage?: Damage | null };

/**
 * @param bytes of a file
 * @param read passes the file to the core; called again if the colours need rare decoders
 * @throws with a `code`, if the file cannot be decoded
 */
export async function reading<T>(
  bytes: Uint8Array<ArrayBuffer>,
  read: (file: Uint8Array<ArrayBuffer>) => T,
): Promise<{ value: T; told: Told }> {
  const foreign = foreignKind(bytes);
  if (foreign) {
    const told = { format: foreign, taken: taken_in_boxes(bytes) ?? null };
    return { value: read(await asBmp(foreign, bytes)), told };
  }
  if (!rareKind(bytes)) {
    try {
      return { value: read(bytes), told: {} };
    } catch (error) {
      if ((error as { code?: string }).code !== 'rare-colours') throw error;
    }
  }
  const { file, ...told } = await converted(bytes);
  return { value: read(file), told };
}
