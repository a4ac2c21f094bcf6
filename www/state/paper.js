// @ts-check
/**
 * Page sizes a person knows, in pixels of the export.
 */

/** @typedef {import('../engine/documents.js').PageSettings} PageSettings */
/** @typedef {{ id: string, width: number, height: number, dpi: number }} PageSize */

/** As the core offers them, the default first. @type {readonly PageSize[]} */
export const PAGE_SIZES = [
  { id: 'a4', width: 2480, height: 3508, dpi: 300 },
  { id: 'a4-landscape', width: 3508, height: 2480, dpi: 300 },
  { id: 'letter', width: 2550, height: 3300, dpi: 300 },
  { id: 'square', width: 2400, height: 2400, dpi: 300 },
  { id: 'wide', width: 3840, height: 2160, dpi: 96 },
  { id: 'story', width: 1440, height: 2560, dpi: 96 },
  { id: 'portrait', width: 2160, height: 2700, dpi: 96 },
  { id: 'webtoon', width: 1600, height: 4000, dpi: 96 },
];

/**
 * @param {{ width: number, height: number }} settings
 * @returns {string} the id of the size, or `custom`
 */
export function sizeId({ width, height }) {
  return PAGE_SIZES.find((size) => size.width === width && size.height === height)?.id ?? 'custom';
}

/**
 * @param {PageSettings} settings
 * @param {Partial<PageSettings>} size
 * @returns {PageSettings}
 */
export function sized(settings, { width = settings.width, height = settings.height, dpi = settings.dpi }) {
  return { ...settings, width, height, dpi };
}

/**
 * The same page with fewer or more pixels.
 * @param {{ width: number, height: number, dpi: number }} size
 * @param {number} factor
 */
export function scaled({ width, height, dpi }, factor) {
  return { width: Math.round(width * factor), height: Math.round(height * factor), dpi: Math.round(dpi * factor) };
}

/** @typedef {'px' | 'mm' | 'in'} Unit */

/** @type {readonly Unit[]} */
export const UNITS = ['px', 'mm', 'in'];

/** What the core takes: pixels a side and a page, dots an inch. */
export const LEAST_SIDE = 64;
export const MOST_SIDE = 14_000;
export const MOST_PIXELS = 72_000_000;
export const LEAST_DPI = 36;
export const MOST_DPI = 1200;

/**
 * @param {number} pixels
 * @param {Unit} unit
 * @param {number} dpi
 * @returns {number} the length in the unit, rounded as one would write it
 */
export function lengthIn(pixels, unit, dpi) {
  if (unit === 'px') return pixels;
  const inches = pixels / dpi;
  return unit === 'in' ? Math.round(inches * 100) / 100 : Math.round(inches * 254) / 10;
}

/**
 * @param {number} length
 * @param {Unit} unit
 * @param {number} dpi
 * @returns {number} whole pixels
 */
export function pixelsOf(length, unit, dpi) {
  if (unit === 'px') return Math.round(length);
  return Math.round(unit === 'in' ? length * dpi : length / 25.4 * dpi);
}

/**
 * @param {{ width: number, height: number, dpi: number }} size
 * @returns {'' | 'side' | 'pixels' | 'dpi'} what the core would not take
 */
export function whyNotSize({ width, height, dpi }) {
  const within = (/** @type {number} */ value, /** @type {number} */ least, /** @type {number} */ most) => value >= least && value <= most;
  if (!within(dpi, LEAST_DPI, MOST_DPI)) return 'dpi';
  if (!within(width, LEAST_SIDE, MOST_SIDE) || !within(height, LEAST_SIDE, MOST_SIDE)) return 'side';
  return width * height > MOST_PIXELS ? 'pixels' : '';
}
