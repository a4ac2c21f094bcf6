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
  filesSkipped: (n: number) =>
    n === 1
      ? 'Se omitió 1 archivo que un sistema o programa guarda junto a las fotos.'
      : `Se omitieron ${n} archivos que sistemas y programas guardan junto a las fotos.`,
  /** `remedy`: a request to the user */
  unsupportedKind: (name: string, remedy: string) => `este tipo de archivo (${name}) no se puede leer. ${remedy}`,
  remedies: {
    jpeg: 'Guárdalo como JPEG con un programa que lo abra.',
    unpack: 'Descomprímelo y añade sus imágenes, o comprímelas como ZIP.',
    pages: 'Guarda sus páginas como PNG o JPEG.',
    mp4: 'Conviértelo a MP4 con vídeo H.264.',
    srt: 'Conviértelo a SRT o WebVTT.',
    fountain: 'Expórtalo como Fountain.',
    csv: 'Guárdalo como CSV.',
    text: 'Guárdalo como texto sin formato.',
  },
  boardFile: 'es un guion o una tabla. Abre el storyboard y elige «Importar guion o tabla».',
  liveVideos: (n: number) =>
    n === 1
      ? 'No se añadió 1 vídeo de una Live Photo, solo su foto.'
      : `No se añadieron ${n} vídeos de Live Photos, solo sus fotos.`,
  addLiveVideos: (n: number): string => (n === 1 ? 'Añadir el vídeo' : 'Añadir los vídeos'),
};
