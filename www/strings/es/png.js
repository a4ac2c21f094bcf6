// @ts-check
const photos = (/** @type {number} */ n) => (n === 1 ? '1 foto' : `${n} fotos`);

/** @param {readonly string[]} names @returns {string} some of them, and how many more */
function some(names) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} y ${rest} más` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Dentro del PNG',
  cargoKind: { project: 'Con datos del proyecto', photos: 'Con fotos', none: 'Sin datos del proyecto' },
  cargoHelp: {
    project: 'Suelta aquí el PNG para seguir trabajando en él. Encuentra sus fotos en este dispositivo.',
    photos: 'Se abre en cualquier dispositivo, con las fotos. Quien tenga el archivo las tiene.',
    none: 'La imagen y nada más.',
  },
  cargoClean: 'El lugar, la fecha y la cámara de tus fotos nunca están en él.',
  photosUnclean: (/** @type {number} */ n) => `${photos(n)} en él ${n === 1 ? 'puede' : 'pueden'} decir todavía dónde y cuándo: Inkpanel no puede quitarlo de archivos de ese tipo.`,

  noProjectInside: 'es una imagen sin datos de proyecto.',
  pageOpened: (/** @type {string} */ name) => `${name} está abierto de nuevo, como proyecto propio.`,
  photosMissing: (/** @type {string} */ name, /** @type {number} */ n, /** @type {number} */ of) => (
    `${name} está abierto, pero ${n === 1 ? `falta en este dispositivo 1 de sus ${of} fotos` : `faltan en este dispositivo ${n} de sus ${of} fotos`}. Elige o suelta ${n === 1 ? 'la foto' : 'las fotos'}: cada una vuelve a su sitio.`
  ),
  photosBack: (/** @type {number} */ n) => `${photos(n)} de vuelta en su sitio.`,
  photosStillMissing: (/** @type {number} */ n) => `${n === 1 ? 'Falta' : 'Faltan'} todavía ${photos(n)} de esta página. Elige o suelta ${n === 1 ? 'la foto' : 'las fotos'}: cada una vuelve a su sitio.`,
  absentPhoto: (/** @type {number} */ n) => `Foto que falta ${n}`,
  choosePhotos: 'Elegir fotos',
  useAsPhoto: 'Usar como foto',
  backTo: (/** @type {string} */ name) => `Volver a ${name}`,

  projectSaved: (/** @type {readonly string[]} */ unclean) => (
    unclean.length === 0
      ? 'El proyecto se ha guardado como archivo, con tus fotos a tamaño completo, pero sin su lugar, fecha ni cámara.'
      : `El proyecto se ha guardado como archivo, con tus fotos a tamaño completo. ${some(unclean)} ${unclean.length === 1 ? 'puede' : 'pueden'} decir todavía dónde y cuándo: Inkpanel no puede quitarlo de archivos de ese tipo.`
  ),
};
