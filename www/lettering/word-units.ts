/** The units of the fields of a text item: millimetres and points for print, pixels for screens. */

import type { PageSettings } from '../engine/types.ts';

/** Pages with fewer dots per inch are for screens. */
const PRINT_DPI = 150;
const INCH = 25.4;
const POINTS = 72;

/** `per`: units per page width. */
export type Unit = { unit: 'mm' | 'pt' | 'px'; per: number; digits: number };

/** Returns the units of lengths and of text sizes on a page. */
export function unitsOf({ width, dpi }: Pick<PageSettings, 'width' | 'dpi'>): { length: Unit; text: Unit } {
  if (dpi < PRINT_DPI) {
    const pixels: Unit = { unit: 'px', per: width, digits: 0 };
    return { length: pixels, text: pixels };
  }
  const inches = width / dpi;
  return {
    length: { unit: 'mm', per: inches * INCH, digits: 1 },
    text: { unit: 'pt', per: inches * POINTS, digits: 1 },
  };
}

/** Limits of the text size, in page widths. */
export const [LEAST_SIZE, MOST_SIZE] = [0.005, 0.4];
