/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'Dentro del archivo',
  cargoFileHelp: {
    project: 'Suelta el archivo aquí para editarlo de nuevo. Encuentra sus fotos en este dispositivo.',
    photos:
      'Incluye tus fotos originales, así que se abre en cualquier dispositivo. Cualquiera que tenga el archivo puede verlas.',
    none: 'Solo las páginas.',
  },
  packingPhotos: (percent: string) => `Añadiendo las fotos, ${percent}`,
  photosTooLarge: 'juntas, las fotos son demasiado grandes para un PNG. Guarda mejor el proyecto como archivo.',
  savingProject: (done: number, total: number) => `Guardando el proyecto, ${Math.floor(done)} de ${total} archivos`,
  damagedInArchive: (archive: string) => `está dañada en ${archive}.`,
  noPicturesInside: 'no hay ninguna imagen dentro.',
  unknownJson: 'no es una plantilla ni un estilo de Inkpanel.',
};
