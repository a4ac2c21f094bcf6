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
