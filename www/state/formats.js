// @ts-check
/** The kinds of files that pages become, and what the files are called. */

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {'png' | 'jpeg' | 'webp' | 'pdf' | 'zip' | 'cbz'} Format */
/** @typedef {'png' | 'jpeg'} Inside the pictures of a ZIP or CBZ file */

/** @type {Record<Format, { ending: string, type: string, lossy: boolean }>} */
export const FORMATS = {
  png: { ending: 'png', type: 'image/png', lossy: false },
  jpeg: { ending: 'jpg', type: 'image/jpeg', lossy: true },
  webp: { ending: 'webp', type: 'image/webp', lossy: true },
  pdf: { ending: 'pdf', type: 'application/pdf', lossy: true },
  zip: { ending: 'zip', type: 'application/zip', lossy: false },
  cbz: { ending: 'cbz', type: 'application/vnd.comicbook+zip', lossy: false },
};

/** @type {readonly Format[]} */
export const OF_ONE = ['png', 'jpeg', 'webp', 'pdf'];
/** @type {readonly Format[]} */
export const OF_MANY = ['pdf', 'zip', 'cbz'];

/** @param {Format} format */
export function isArchive(format) {
  return format === 'zip' || format === 'cbz';
}

/**
 * @param {readonly PageDocument[]} pages
 * @param {Format} format
 * @returns {string} the name of the file
 */
export function fileName(pages, format) {
  const { ending } = FORMATS[format];
  if (pages.length > 1) return `inkpanel-${pages.length}-pages.${ending}`;
  const [{ layout, style, seed }] = pages;
  return `inkpanel-${nameOf(layout)}-${nameOf(style)}-${seed}.${ending}`;
}

/**
 * @param {number} index from 0
 * @param {number} count of all pages
 * @param {Inside} inside
 * @returns {string} the name of a page in an archive, so that the order of names is the order of pages
 */
export function pageName(index, count, inside) {
  const digits = Math.max(2, String(count).length);
  return `page-${String(index + 1).padStart(digits, '0')}.${FORMATS[inside].ending}`;
}

/** @param {PageDocument} page @param {number} index from 0 */
export function panelName(page, index) {
  return fileName([page], 'png').replace(/\.png$/, `-panel-${index + 1}.png`);
}

/** @param {string | { id?: string }} part */
function nameOf(part) {
  return typeof part === 'string' ? part : part.id ?? 'own';
}
