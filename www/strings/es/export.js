// @ts-check
/** @param {number} bytes */
function size(bytes) {
  if (bytes < 1e6) return `${Math.max(1, Math.round(bytes / 1e3))} KB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0).replace('.', ',')} MB`;
}

export const exportStrings = {
  exportPage: 'Exportar la página',
  resolution: 'Calidad',
  full: (/** @type {number} */ dpi) => (dpi >= 150 ? `Impresión, ${dpi} ppp` : 'Tamaño completo'),
  half: 'La mitad, para la web',
  format: 'Formato',
  formats: {
    png: 'PNG, sin pérdida', jpeg: 'JPEG, ligero', webp: 'WebP, más ligero', pdf: 'PDF, nítido siempre',
    zip: 'ZIP, una imagen por página', cbz: 'CBZ, para lectores de cómic',
  },
  pictures: 'Imágenes dentro',
  insides: { png: 'PNG, sin pérdida', jpeg: 'JPEG, ligero' },
  pictureQuality: 'Calidad de imagen',
  whichPages: 'Páginas',
  allPages: (/** @type {number} */ count) => `Las ${count} páginas`,
  pixels: (/** @type {number} */ w, /** @type {number} */ h) => `${w} × ${h} píxeles`,
  aboutSize: (/** @type {number} */ bytes) => `unos ${size(bytes)}`,
  measuring: 'midiendo su tamaño…',
  save: 'Guardar el archivo',
  copyPage: 'Copiar al portapapeles',
  shareFile: 'Compartir',
  sharePart: 'Compartir ahora',
  savePanel: 'Guardar esta viñeta',
  noPhotoHere: 'esta viñeta está vacía',
  exporting: (/** @type {number} */ percent) => `Dibujando la página a tamaño completo, ${percent} %`,
  pagesSaved: (/** @type {number} */ count) => (count === 1 ? 'La página se ha guardado.' : `Se han guardado ${count} páginas en un archivo.`),
  panelSaved: 'La viñeta se ha guardado.',
  copied: 'La página está en el portapapeles.',
  readyToShare: 'El archivo está listo.',
  exportFailed: (/** @type {string} */ why) => `No se ha podido crear el archivo: ${why}`,
  copyFailed: (/** @type {string} */ why) => `No se ha podido copiar la página: ${why} Guárdala como archivo.`,
  shareFailed: (/** @type {string} */ why) => `No se ha podido compartir el archivo: ${why} Guárdalo.`,
};
