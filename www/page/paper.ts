/**
 * Page sizes a person knows, in pixels of the export.
 */

import type { PageSettings } from '../engine/types.ts';

type PageSize = { id: string; width: number; height: number; dpi: number };

/** As the core offers them, the default first. */
export const PAGE_SIZES: readonly PageSize[] = [
  { id: 'a4', width: 2480, height: 3508, dpi: 300 },
  { id: 'a4-landscape', width: 3508, height: 2480, dpi: 300 },
  { id: 'letter', width: 2550, height: 3300, dpi: 300 },
  { id: 'square', width: 2400, height: 2400, dpi: 300 },
  { id: 'wide', width: 3840, height: 2160, dpi: 96 },
  { id: 'story', width: 1440, height: 2560, dpi: 96 },
  { id: 'portrait', width: 2160, height: 2700, dpi: 96 },
  { id: 'webtoon', width: 1600, height: 4000, dpi: 96 },
];

/** @returns the id of the size, or `custom` */
export function sizeId({ width, height }: { width: number; height: number }): string {
  return PAGE_SIZES.find((size) => size.width === width && size.height === height)?.id ?? 'custom';
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

/** What the core takes: pixels a side and a page, dots an inch. */
export const LEAST_SIDE = 64;
export const MOST_SIDE = 14_000;
export const MOST_PIXELS = 72_000_000;
export const LEAST_DPI = 36;
export const MOST_DPI = 1200;

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

/** @returns what the core would not take */
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
  if (!within(dpi, LEAST_DPI, MOST_DPI)) return 'dpi';
  if (!within(width, LEAST_SIDE, MOST_SIDE) || !within(height, LEAST_SIDE, MOST_SIDE)) return 'side';
  return width * height > MOST_PIXELS ? 'pixels' : '';
}
