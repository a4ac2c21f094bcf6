/**
 * Common page sizes, in pixels of the export.
 */

import { PAGE, PAGE_SIZES } from '../engine/bounds.ts';
import type { PageSettings } from '../engine/types.ts';

export { PAGE_SIZES };

/** Colours of the page that a dark style gets instead of the default ones, as in `crates/engine/src/page/styling.rs`. */
export const DARK_PAPER = Object.freeze({ paper: '#15141a', borderColor: '#07070a' });

/** @returns the id of the size, or `custom` */
export function sizeId({ width, height }: { width: number; height: number }): string {
  return PAGE_SIZES.find((size) => size.width === width && size.height === height)?.id ?? 'custom';
}

/** Safe distance of faces and text from the edge of a page with a custom size, as a fraction of its shorter side. */
const USUAL_SAFE = 0.03;

/**
 * The area of a page that trimming never cuts off: distances in pixels from its sides, from its top and bottom, and
 * from the fold in its middle.
 */
export function safeArea(page: { width: number; height: number }): { across: number; down: number; fold: number } {
  const known = PAGE_SIZES.find(({ id }) => id === sizeId(page));
  if (known) return { across: known.safe[0], down: known.safe[1], fold: known.fold };
  const room = Math.round(USUAL_SAFE * Math.min(page.width, page.height));
  return { across: room, down: room, fold: 0 };
}

export function sized(
  settings: PageSettings,
  { width = settings.width, height = settings.height, dpi = settings.dpi }: Partial<PageSettings>,
): PageSettings {
  return { ...settings, width, height, dpi };
}

/** The same page with fewer or more pixels. */
export function scaled({ width, height, dpi }: { width: number; height: number; dpi: number }, factor: number) {
  return { width: Math.round(width * factor), height: Math.round(height * factor), dpi: Math.round(dpi * factor) };
}

export type Unit = 'px' | 'mm' | 'in';

export const UNITS: readonly Unit[] = ['px', 'mm', 'in'];

/** @returns the length in the unit, rounded as one would write it */
export function lengthIn(pixels: number, unit: Unit, dpi: number): number {
  if (unit === 'px') return pixels;
  const inches = pixels / dpi;
  return unit === 'in' ? Math.round(inches * 100) / 100 : Math.round(inches * 254) / 10;
}

/** @returns whole pixels */
export function pixelsOf(length: number, unit: Unit, dpi: number): number {
  if (unit === 'px') return Math.round(length);
  return Math.round(unit === 'in' ? length * dpi : (length / 25.4) * dpi);
}

/** @returns the limit that the size exceeds; empty for a valid size */
export function whyNotSize({
  width,
  height,
  dpi,
}: {
  width: number;
  height: number;
  dpi: number;
}): '' | 'side' | 'pixels' | 'dpi' {
  const within = (value: number, least: number, most: number) => value >= least && value <= most;
  if (!within(dpi, PAGE.leastDpi, PAGE.mostDpi)) return 'dpi';
  const isSide = (pixels: number) => within(pixels, PAGE.leastSide, PAGE.mostSide);
  if (!isSide(width) || !isSide(height)) return 'side';
  return width * height > PAGE.mostPixels ? 'pixels' : '';
}
