/** Photos as thumbnails: the part of them that is shown, and how large. */

import { screenPixels } from '../ui/bitmap.tsx';
import type { Bounds, Subject } from '../engine/types.ts';

/** of a photo; null until it is read */
type Size = { width: number; height: number; subjects?: readonly Subject[] } | null | undefined;

/** A style without blocks, which does not change the photo. */
export const PLAIN = Object.freeze({ id: 'plain', name: 'Plain', tags: [], background: [] });

/**
 * A thumbnail in CSS pixels, filled by a photo around its largest face, or by its middle.
 * @param height default: equal to the width
 */
export function thumbnail(photo: Size, width: number, height: number = width) {
  return { width: screenPixels(width), height: screenPixels(height), crop: covering(photo, width / height) };
}

/**
 * The part of a photo that fills a thumbnail, so that nothing is squeezed, around its largest face or in the middle.
 * @param aspect of the thumbnail, width over height
 * @returns in parts of the photo
 */
function covering(photo: Size, aspect: number): Bounds {
  const { width, height } = photo ?? { width: aspect, height: 1 };
  const part = width / height / aspect;
  const [w, h] = [Math.min(1, 1 / part), Math.min(1, part)];
  const [x, y] = middleOf(photo?.subjects ?? []);
  const start = (middle: number, length: number) => Math.min(1 - length, Math.max(0, middle - length / 2));
  return { x: start(x, w), y: start(y, h), width: w, height: h };
}

/** The middle of the largest face, as fractions of the photo; without a face, the middle of the photo. */
export function middleOf(subjects: readonly Subject[]): [number, number] {
  const faces = subjects.filter(({ label }) => label === 'face');
  if (faces.length === 0) return [0.5, 0.5];
  const { x, y, width, height } = faces.reduce((a, b) => (b.width * b.height > a.width * a.height ? b : a));
  return [x + width / 2, y + height / 2];
}
