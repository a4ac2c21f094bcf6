const photos = (n: number) => (n === 1 ? '1 foto' : `${n} fotos`);

export function some(names: readonly string[]) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} y ${rest} más` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Dentro del PNG',
  cargoKind: { project: 'Con datos del proyecto', photos: 'Con las fotos', none: 'Sin datos del proyecto' },
  cargoHelp: {
    project: 'Suelta aquí el PNG para editarlo de nuevo. Encuentra sus fotos en este dispositivo.',
    photos:
      'Incluye tus fotos originales, así que se abre en cualquier dispositivo. Cualquiera que tenga el archivo puede verlas.',
    none: 'Solo la imagen.',
  },
  cargoClean: 'El lugar, la fecha y la cámara de tus fotos nunca van dentro.',
  photosUnclean: (n: number) =>
    `${photos(n)} de dentro quizá digan aún dónde y cuándo: Inkpanel no puede quitarlo de archivos de ese tipo.`,

  noProjectInside: 'es una imagen sin datos de proyecto.',
  pageOpened: (name: string) => `${name} está abierta otra vez, como proyecto propio.`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name} está abierta, pero en este dispositivo ${n === 1 ? 'falta' : 'faltan'} ${n} de ${photos(of)}. ${n === 1 ? 'Elígela o suéltala' : 'Elígelas o suéltalas'} y cada una vuelve a su sitio.`,
  photosBack: (n: number) => `${photos(n)} de vuelta en su sitio.`,
  photosStillMissing: (n: number) =>
    `Aún ${n === 1 ? 'falta' : 'faltan'} ${photos(n)} de esta página. ${n === 1 ? 'Elígela o suéltala' : 'Elígelas o suéltalas'} y cada una vuelve a su sitio.`,
  absentPhoto: (n: number) => `Falta la foto ${n}`,
  choosePhotos: 'Elegir fotos',
  openedAsPicture: (name: string) =>
    `${name} ya es una foto de este proyecto. Las fotos de esa página no están en este dispositivo.`,
  openAsProject: 'Abrir como proyecto',
  useAsPhoto: 'Usar como foto',
  backTo: (name: string) => `Volver a ${name}`,

  removeMetadata: 'Quitar la ubicación y los datos de la cámara',
  removeMetadataHelp:
    'Para archivos que compartes. También se quitan las fechas, así que un libro nuevo no puede ordenar las fotos por días.',
  /** @param unclean: files that kept their metadata; null if no metadata was removed */
  projectSaved: (unclean: readonly string[] | null) =>
    unclean === null
      ? 'El proyecto se ha guardado como archivo, con tus fotos originales. Incluye su lugar, su fecha y los datos de la cámara.'
      : unclean.length === 0
        ? 'El proyecto se ha guardado como archivo, con tus fotos a tamaño completo, pero sin su lugar, fecha ni cámara.'
        : `El proyecto se ha guardado como archivo, con tus fotos a tamaño completo. ${some(unclean)} quizá digan aún dónde y cuándo: Inkpanel no puede quitarlo de archivos de ese tipo.`,
};
