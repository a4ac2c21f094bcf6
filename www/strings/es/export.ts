function size(bytes: number) {
  if (bytes < 1e6) return `${Math.max(1, Math.round(bytes / 1e3))} KB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0).replace('.', ',')} MB`;
}

export const exportStrings = {
  exportPage: 'Exportar la página',
  resolution: 'Calidad',
  full: (dpi: number) => (dpi >= 150 ? `Impresión, ${dpi} ppp` : 'Tamaño completo'),
  half: 'La mitad, para la web',
  format: 'Formato',
  formats: {
    png: 'PNG, sin pérdida',
    jpeg: 'JPEG, ligero',
    webp: 'WebP, más ligero',
    pdf: 'PDF, nítido siempre',
    zip: 'ZIP, una imagen por página',
    cbz: 'CBZ, para lectores de cómic',
  },
  pictures: 'Imágenes dentro',
  insides: { png: 'PNG, sin pérdida', jpeg: 'JPEG, ligero' },
  pictureQuality: 'Calidad de imagen',
  whichPages: 'Páginas',
  allPages: (count: number) => `Las ${count} páginas`,
  pixels: (w: number, h: number) => `${w} × ${h} píxeles`,
  aboutSize: (bytes: number) => `unos ${size(bytes)}`,
  measuring: 'midiendo su tamaño…',
  save: 'Guardar el archivo',
  copyPage: 'Copiar al portapapeles',
  shareFile: 'Compartir',
  sharePart: 'Compartir ahora',
  savePanel: 'Guardar esta viñeta',
  noPhotoHere: 'esta viñeta está vacía',
  exporting: (percent: number) => `Dibujando la página a tamaño completo, ${percent} %`,
  pagesSaved: (count: number) =>
    count === 1 ? 'La página se ha guardado.' : `Se han guardado ${count} páginas en un archivo.`,
  panelSaved: 'La viñeta se ha guardado.',
  copied: 'La página está en el portapapeles.',
  readyToShare: 'El archivo está listo.',
  exportFailed: (why: string) => `No se ha podido crear el archivo: ${why}`,
  copyFailed: (why: string) => `No se ha podido copiar la página: ${why} Guárdala como archivo.`,
  shareFailed: (why: string) => `No se ha podido compartir el archivo: ${why} Guárdalo.`,
};
