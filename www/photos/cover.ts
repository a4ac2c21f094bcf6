/** Photos as thumbnails: the part of them that is shown, and how large. */

import { screenPixels } from '../ui/bitmap.tsx';
import type { Bounds } from '../engine/types.ts';

/** of a photo; null until it is read */
type Size = { width: number; height: number } | null | undefined;

/** A style without blocks, which does not change the photo. */
export const PLAIN = Object.freeze({ id: 'plain', name: 'Plain', tags: [], background: [] });

/**
 * A thumbnail in CSS pixels, filled by the middle of a photo.
 * @param height default: equal to the width
 */
export function thumbnail(photo: Size, width: number, height: number = width) {
  return { width: screenPixels(width), height: screenPixels(height), crop: covering(photo, width / height) };
}

/**
 * The part in the middle of a photo that fills a thumbnail, so that nothing is squeezed.
 * @param aspect of the thumbnail, width over height
 * @returns in parts of the photo
 */
function covering(photo: Size, aspect: number): Bounds {
  const { width, height } = photo ?? { width: aspect, height: 1 };
  const part = width / height / aspect;
  const [w, h] = [Math.min(1, 1 / part), Math.min(1, part)];
  return { x: (1 - w) / 2, y: (1 - h) / 2, width: w, height: h };
}
