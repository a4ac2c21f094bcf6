/** The table of places by location: one optional file, loaded with the first photo that has a location. */

import { foreignKind } from './foreign.ts';
import { moduleBytes } from './module-bytes.ts';

/** Address of the table, if the site contains it. Missing files are never requested. */
const [ADDRESS] = Object.values(
  import.meta.glob('../models/places.bin', { query: '?url', import: 'default', eager: true }),
) as string[];
/** Bytes at the beginning of a file that contain its EXIF record; a JPEG segment has at most 64 kB. */
const HEAD = 256 * 1024;
/** Maximum size of a file that is read as a whole. */
const MOST_BYTES = 64 * 2 ** 20;

/** Names the place of a photo from its bytes; undefined if the place is unknown. */
export type NameOf = (bytes: Uint8Array) => string | undefined;

/** @returns the part of a photo that contains its location; null without one */
export async function locationOf(file: Blob): Promise<Uint8Array | null> {
  const head = new Uint8Array(await file.slice(0, HEAD).arrayBuffer());
  // The record of HEIC may be anywhere in the file.
  const whole = foreignKind(head) && file.size > HEAD && file.size <= MOST_BYTES;
  const bytes = whole ? new Uint8Array(await file.arrayBuffer()) : head;
  const { has_location } = await import('../pkg/inkpanel.js');
  return has_location(bytes) ? bytes : null;
}

/** @returns null if the site has no table, or if it cannot be loaded */
export async function loadPlaces(): Promise<NameOf | null> {
  if (!ADDRESS) return null;
  try {
    const packed = await moduleBytes(new URL(ADDRESS, import.meta.url), 'places', 'The places could not be loaded.');
    const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    const { PlaceTable } = await import('../pkg/inkpanel.js');
    const table = new PlaceTable(new Uint8Array(await new Response(unpacked).arrayBuffer()));
    return (bytes) => table.name_of(bytes);
  } catch {
    return null;
  }
}
