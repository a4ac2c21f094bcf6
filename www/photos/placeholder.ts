/**
 * Placeholder of a missing photo: an empty frame with diagonals, as in page layout programs. It is light in every
 * style, and has the shape of the photo, so that its crop stays the same.
 */

import { chunkOf, pngOf } from '../engine/png-chunks.ts';
import type { Absent, Fact } from '../document/album.ts';

/** The identity of an unknown photo. */
export const UNLIKE = Object.freeze({ hash: '', fingerprint: '', width: 1500, height: 1000 });

/** @returns the identity of its photo, and its properties */
export function absentOf({ meta, measures, looked, absent }: Fact): Absent {
  if (absent) return absent;
  if (!meta) return { ...UNLIKE, subjects: null, measured: true };
  const { fingerprint, width, height, subjects } = meta;
  return { hash: '', fingerprint, width, height, subjects: looked ? subjects : null, measured: measures !== null };
}

/**
 * @param facts of photos that are gone
 * @returns frames that keep their places, under their names
 */
export async function emptyFrames(facts: readonly Fact[]): Promise<{ fact: Fact; file: File }[]> {
  /** Most photos of an album are of one or two shapes. */
  const made: Map<string, Promise<Blob>> = new Map();
  return Promise.all(
    facts.map(async (fact) => {
      const absent = absentOf(fact);
      const shape = `${absent.width} ${absent.height}`;
      const picture = made.get(shape) ?? placeholderOf(absent);
      made.set(shape, picture);
      return {
        fact: { ...fact, measures: null, looked: true, absent },
        file: new File([await picture], fact.name, { type: 'image/png' }),
      };
    }),
  );
}

/** Pixels of the longer side, and of a line. */
const [LONGEST, LINE] = [480, 2];
const [GROUND, INK] = [236, 196];

/** @returns a PNG */
export async function placeholderOf(photo: { width: number; height: number }): Promise<Blob> {
  const scale = LONGEST / Math.max(photo.width, photo.height);
  const [width, height] = [photo.width, photo.height].map((side) => Math.max(8, Math.round(side * scale)));
  // Each row begins with its filter type, which is 0.
  const rows = new Uint8Array((width + 1) * height).fill(GROUND);
  const longer = Math.hypot(width, height);
  for (let y = 0; y < height; y += 1) {
    const row = y * (width + 1);
    rows[row] = 0;
    for (let x = 0; x < width; x += 1) {
      const [fall, rise] = [x * height - y * width, x * height - (height - y) * width];
      const edge = Math.min(x, y, width - 1 - x, height - 1 - y) < LINE;
      if (edge || Math.min(Math.abs(fall), Math.abs(rise)) < (LINE * longer) / 2) rows[row + 1 + x] = INK;
    }
  }
  const head = new DataView(new ArrayBuffer(13));
  head.setUint32(0, width);
  head.setUint32(4, height);
  // Eight bits of grey.
  head.setUint8(8, 8);
  const pixels = await new Response(new Blob([rows]).stream().pipeThrough(new CompressionStream('deflate'))).blob();
  return pngOf([
    await chunkOf('IHDR', new Uint8Array(head.buffer)),
    await chunkOf('IDAT', pixels),
    await chunkOf('IEND', new Blob([])),
  ]);
}
