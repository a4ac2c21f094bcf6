/**
 * Manual crops: the part of a photo that a panel shows. A crop never leaves the photo. All values are fractions of the
 * photo.
 */

import type { Bounds as Crop } from '../../engine/types.ts';

export type { Crop };
type Size = { width: number; height: number };
type Subject = { x: number; y: number; width: number; height: number; label: string; score: number };

/** The least part of a photo's side that a crop shows. */
const LEAST = 0.06;
/** Size of the crop around a fitted subject, in sides of the subject. */
const ROOM = 1.35;

/**
 * The picture follows the pointer.
 * @param byX in widths of the panel
 * @param byY in its heights
 */
export function panned(crop: Crop, byX: number, byY: number): Crop {
  return inside({ ...crop, x: crop.x - byX * crop.width, y: crop.y - byY * crop.height });
}

/**
 * @param factor values above 1 zoom in
 * @param at the fixed point, as fractions of the panel
 */
export function zoomed(crop: Crop, factor: number, [u, v]: [number, number] = [0.5, 0.5]): Crop {
  const widest = 1 / Math.max(crop.width, crop.height);
  const closest = Math.min(1, LEAST / Math.max(crop.width, crop.height));
  const scale = Math.min(widest, Math.max(closest, 1 / factor));
  const [width, height] = [crop.width * scale, crop.height * scale];
  return inside({ x: crop.x + u * (crop.width - width), y: crop.y + v * (crop.height - height), width, height });
}

/**
 * The crop that shows the subject large: all faces, or without faces the detection with the highest score.
 * @param photo in pixels
 * @param aspect of the panel, width over height
 * @returns `null` without a subject
 */
export function fitted(subjects: readonly Subject[], photo: Size, aspect: number): Crop | null {
  const faces = subjects.filter(({ label }) => label === 'face');
  const best = [...subjects].sort((a, b) => b.score - a.score).slice(0, 1);
  const shown = faces.length > 0 ? faces : best;
  if (shown.length === 0) return null;
  const left = Math.min(...shown.map(({ x }) => x));
  const top = Math.min(...shown.map(({ y }) => y));
  const right = Math.max(...shown.map(({ x, width }) => x + width));
  const bottom = Math.max(...shown.map(({ y, height }) => y + height));
  const needed = Math.max((right - left) * photo.width * ROOM, (bottom - top) * photo.height * ROOM * aspect);
  const least = LEAST * Math.max(photo.width, photo.height * aspect);
  const wide = Math.min(Math.max(needed, least), photo.width, photo.height * aspect);
  const [width, height] = [wide / photo.width, wide / aspect / photo.height];
  return inside({ x: (left + right - width) / 2, y: (top + bottom - height) / 2, width, height });
}

function inside({ x, y, width, height }: Crop): Crop {
  const [w, h] = [Math.min(1, width), Math.min(1, height)];
  return { x: Math.min(1 - w, Math.max(0, x)), y: Math.min(1 - h, Math.max(0, y)), width: w, height: h };
}
