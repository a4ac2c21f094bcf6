/**
 * Identity of a photo: the SHA-256 of its file without metadata. So a photo is the same before and after it went
 * through a project file.
 */

import { withoutMetadata } from '../engine/metadata/strip.ts';
import type { Stripped } from '../engine/metadata/strip.ts';
import type { Likeness } from '../engine/types.ts';

/**
 * Identity of a photo: `hash` of 64 hex digits, empty if the browser cannot compute it; `fingerprint` of 16; and the
 * upright size in pixels.
 */
export type { Likeness };

/** Files larger than this are recognised by their looks. */
const MOST_BYTES = 256 * 2 ** 20;

const stripped: WeakMap<Blob, Promise<Stripped>> = new WeakMap();
const hashes: WeakMap<Blob, Promise<string>> = new WeakMap();

/** @returns worked out once */
export function strippedOf(file: Blob): Promise<Stripped> {
  const known = stripped.get(file) ?? withoutMetadata(file);
  stripped.set(file, known);
  known.catch(() => stripped.delete(file));
  return known;
}

/** @returns 64 hex digits; empty if hashing is not available, as on a site without https */
export function hashOf(file: Blob): Promise<string> {
  const known = hashes.get(file) ?? hashed(file);
  hashes.set(file, known);
  return known;
}

async function hashed(file: Blob) {
  if (!globalThis.crypto?.subtle || file.size === 0 || file.size > MOST_BYTES) return '';
  try {
    const { blob } = await strippedOf(file);
    const digest = await crypto.subtle.digest('SHA-256', await blob.arrayBuffer());
    return [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
  } catch {
    // A file that went away is missed where its pixels are needed.
    return '';
  }
}

export function looksLike(
  one: { fingerprint: string; width: number; height: number },
  other: { fingerprint: string; width: number; height: number },
) {
  return one.fingerprint === other.fingerprint && one.width === other.width && one.height === other.height;
}
