/** Words of files and other ways out. */

function size(bytes: number) {
  if (bytes < 1e6) return `${Math.max(1, Math.round(bytes / 1e3))} KB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB`;
}

export const exportStrings = {
  exportPage: 'Export the page',
  resolution: 'Quality',
  full: (dpi: number) => (dpi >= 150 ? `Print, ${dpi} dpi` : 'Full size'),
  half: 'Half, for the web',
  format: 'Format',
  formats: {
    png: 'PNG, lossless',
    jpeg: 'JPEG, small',
    webp: 'WebP, smaller',
    pdf: 'PDF, sharp at any size',
    zip: 'ZIP, a picture a page',
    cbz: 'CBZ, for comic readers',
  },
  pictures: 'Pictures in it',
  insides: { png: 'PNG, lossless', jpeg: 'JPEG, small' },
  pictureQuality: 'Picture quality',
  whichPages: 'Pages',
  allPages: (count: number) => `All ${count} pages`,
  pixels: (w: number, h: number) => `${w} × ${h} pixels`,
  aboutSize: (bytes: number) => `about ${size(bytes)}`,
  measuring: 'measuring its size…',
  save: 'Save the file',
  copyPage: 'Copy to clipboard',
  shareFile: 'Share',
  sharePart: 'Share now',
  savePanel: 'Save this panel',
  noPhotoHere: 'this panel is empty',
  exporting: (percent: number) => `Drawing the page at full size, ${percent} %`,
  pagesSaved: (count: number) => (count === 1 ? 'The page was saved.' : `${count} pages were saved in one file.`),
  panelSaved: 'The panel was saved.',
  copied: 'The page is on the clipboard.',
  readyToShare: 'The file is ready.',
  exportFailed: (why: string) => `The file could not be made: ${why}`,
  copyFailed: (why: string) => `The page could not be copied: ${why} Save it as a file instead.`,
  shareFailed: (why: string) => `The file could not be shared: ${why} Save it instead.`,
};
