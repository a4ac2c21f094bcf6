// @ts-check
const photos = (/** @type {number} */ n) => (n === 1 ? '1 foto' : `${n} fotos`);

/** @param {readonly string[]} names */
export function some(names) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} y ${rest} más` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Dentro del PNG',
  cargoKind: { project: 'Con datos del proyecto', photos: 'Con las fotos', none: 'Sin datos del proyecto' },
  cargoHelp: {
    project: 'Suelta aquí el PNG para seguir trabajando en él. Encuentra sus fotos en este dispositivo.',
    photos: 'Se abre en cualquier dispositivo, con las fotos. Quien tiene el archivo las tiene.',
    none: 'La imagen y nada más.',
  },
  cargoClean: 'El lugar, la fecha y la cámara de tus fotos nunca van dentro.',
  photosUnclean: (/** @type {number} */ n) => `${photos(n)} de dentro quizá digan aún dónde y cuándo: Inkpanel no puede quitarlo de archivos de ese tipo.`,

  noProjectInside: 'es una imagen sin datos de proyecto.',
  pageOpened: (/** @type {string} */ name) => `${name} está abierta otra vez, como proyecto propio.`,
  photosMissing: (/** @type {string} */ name, /** @type {number} */ n, /** @type {number} */ of) => (
    `${name} está abierta, pero en este dispositivo ${n === 1 ? 'falta' : 'faltan'} ${n} de ${photos(of)}. ${n === 1 ? 'Elígela o suéltala' : 'Elígelas o suéltalas'} y cada una vuelve a su sitio.`
  ),
  photosBack: (/** @type {number} */ n) => `${photos(n)} de vuelta en su sitio.`,
  photosStillMissing: (/** @type {number} */ n) => `Aún ${n === 1 ? 'falta' : 'faltan'} ${photos(n)} de esta página. ${n === 1 ? 'Elígela o suéltala' : 'Elígelas o suéltalas'} y cada una vuelve a su sitio.`,
  absentPhoto: (/** @type {number} */ n) => `Falta la foto ${n}`,
  choosePhotos: 'Elegir fotos',
  useAsPhoto: 'Usar como foto',
  backTo: (/** @type {string} */ name) => `Volver a ${name}`,

  projectSaved: (/** @type {readonly string[]} */ unclean) => (
    unclean.length === 0
      ? 'El proyecto se ha guardado como archivo, con tus fotos a tamaño completo, pero sin su lugar, fecha ni cámara.'
      : `El proyecto se ha guardado como archivo, con tus fotos a tamaño completo. ${some(unclean)} quizá digan aún dónde y cuándo: Inkpanel no puede quitarlo de archivos de ese tipo.`
  ),
};
