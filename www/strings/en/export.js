// @ts-check
/** Words of files and other ways out. */

/** @param {number} bytes */
function size(bytes) {
  if (bytes < 1e6) return `${Math.max(1, Math.round(bytes / 1e3))} KB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB`;
}

export const exportStrings = {
  exportPage: 'Export the page',
  resolution: 'Quality',
  full: (/** @type {number} */ dpi) => (dpi >= 150 ? `Print, ${dpi} dpi` : 'Full size'),
  half: 'Half, for the web',
  format: 'Format',
  formats: {
    png: 'PNG, lossless', jpeg: 'JPEG, small', webp: 'WebP, smaller', pdf: 'PDF, sharp at any size',
    zip: 'ZIP, a picture a page', cbz: 'CBZ, for comic readers',
  },
  pictures: 'Pictures in it',
  insides: { png: 'PNG, lossless', jpeg: 'JPEG, small' },
  pictureQuality: 'Picture quality',
  whichPages: 'Pages',
  allPages: (/** @type {number} */ count) => `All ${count} pages`,
  pixels: (/** @type {number} */ w, /** @type {number} */ h) => `${w} × ${h} pixels`,
  aboutSize: (/** @type {number} */ bytes) => `about ${size(bytes)}`,
  measuring: 'measuring its size…',
  save: 'Save the file',
  copyPage: 'Copy to clipboard',
  shareFile: 'Share',
  sharePart: 'Share now',
  savePanel: 'Save this panel',
  noPhotoHere: 'this panel is empty',
  exporting: (/** @type {number} */ percent) => `Drawing the page at full size, ${percent} %`,
  pagesSaved: (/** @type {number} */ count) => (count === 1 ? 'The page was saved.' : `${count} pages were saved in one file.`),
  panelSaved: 'The panel was saved.',
  copied: 'The page is on the clipboard.',
  readyToShare: 'The file is ready.',
  exportFailed: (/** @type {string} */ why) => `The file could not be made: ${why}`,
  copyFailed: (/** @type {string} */ why) => `The page could not be copied: ${why} Save it as a file instead.`,
  shareFailed: (/** @type {string} */ why) => `The file could not be shared: ${why} Save it instead.`,
};
