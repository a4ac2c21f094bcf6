// @ts-check
/**
 * What a photo is known by, wherever it lies: the SHA-256 of its file without what cameras and programs write beside the
 * pixels. So a photo is the same before and after it went through a project file.
 */

import { withoutMetadata } from '../../engine/metadata/strip.js';

/** @typedef {import('../../engine/metadata/strip.js').Stripped} Stripped */

/**
 * How a photo is recognised: `hash` of 64 hex digits, empty where the browser makes none; `fingerprint` of 16, and the
 * sides in pixels, upright.
 * @typedef {{ hash: string, fingerprint: string, width: number, height: number }} Likeness
 */

/** Files larger than this are recognised by their looks. */
const MOST_BYTES = 256 * 2 ** 20;

/** @type {WeakMap<Blob, Promise<Stripped>>} */
const stripped = new WeakMap();
/** @type {WeakMap<Blob, Promise<string>>} */
const hashes = new WeakMap();

/** @param {Blob} file @returns {Promise<Stripped>} worked out once */
export function strippedOf(file) {
  const known = stripped.get(file) ?? withoutMetadata(file);
  stripped.set(file, known);
  known.catch(() => stripped.delete(file));
  return known;
}

/** @param {Blob} file @returns {Promise<string>} 64 hex digits; empty where there is no telling, as on a page without https */
export function hashOf(file) {
  const known = hashes.get(file) ?? hashed(file);
  hashes.set(file, known);
  return known;
}

/** @param {Blob} file */
async function hashed(file) {
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

/** @param {{ fingerprint: string, width: number, height: number }} one @param {{ fingerprint: string, width: number, height: number }} other */
export function looksLike(one, other) {
  return one.fingerprint === other.fingerprint && one.width === other.width && one.height === other.height;
}
