/** Shots that look like the shot before, such as two frames of one camera setting. */

import type { Album } from '../document/album.ts';
import type { ShotRow } from './shots.ts';

/**
 * Maximum fingerprint distance of similar shots, in bits of 64. Only neighbours are compared, so it may be higher than for
 * near-duplicates of a whole album (`docs/reports/near-duplicates.md`).
 */
const ALIKE = 13;

/** Returns the ids of the shots that look like the shot before. A shot with its own text or length is never one of them. */
export function similarShots(rows: readonly ShotRow[], album: Album): ReadonlySet<string> {
  const similar = new Set<string>();
  let before: string | undefined;
  for (const { id, shot, said } of rows) {
    const fingerprint = album.get(id)?.meta?.fingerprint;
    const isOwn = Object.keys(shot).length > 0 || Object.values(said).some((text) => text !== '');
    if (!isOwn && before !== undefined && fingerprint !== undefined && distance(before, fingerprint) <= ALIKE)
      similar.add(id);
    else before = fingerprint;
  }
  return similar;
}

/** Returns the number of different bits of two numbers in hexadecimal digits. */
function distance(one: string, other: string): number {
  let bits = BigInt(`0x${one}`) ^ BigInt(`0x${other}`);
  let count = 0;
  for (; bits > 0n; bits &= bits - 1n) count += 1;
  return count;
}
