/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Estilo de una imagen',
  styleFromPictureHelp: 'Aplica a tus fotos el aspecto de una página de cómic, un grabado o una pintura',
  imitationAbout:
    'Elige una imagen con el aspecto que quieras: una página de cómic, un grabado, un dibujo o una pintura. En pocos segundos, Inkpanel encuentra estilos que dan ese aspecto a tu foto. La imagen no sale de este dispositivo.',
  imitationDropHere: 'O suelta una imagen aquí.',
  imitationChoose: 'Elegir una imagen',
  imitationOther: 'Otra imagen',
  imitationFile: 'Imagen con el estilo que quieres',
  imitationAgain: 'Buscar de nuevo',
  imitationAnyway: 'Buscar de todos modos',
  imitating: 'Buscando estilos…',
  imitationProposals: 'Estilos encontrados',
  imitationPhotos: 'Foto para la vista previa',
  imitationNone: 'Ningún estilo se acerca a esta imagen. Prueba con otra.',
  imitationNeedsPhotos: 'Elige primero fotos: Inkpanel muestra los estilos en una de ellas.',
  dropForStyle: 'Suelta aquí, o con Alt pulsada, para tomar el estilo de una imagen',
  imitationFound: (n: number) =>
    n === 1
      ? '1 estilo encontrado. Úsalo, edítalo o guárdalo para conservarlo.'
      : `${n} estilos encontrados. Usa, edita o guarda uno para conservarlo.`,
  imitationName: (picture: string, place: number) => `Como ${picture} ${place}`,
  imitationPictureOf: (name: string) => `La imagen ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Esta imagen es demasiado pequeña. Cada lado necesita al menos 64 píxeles.',
    'blank-picture': 'Esta imagen está vacía, así que no tiene estilo.',
    'plain-photo':
      'Parece una foto corriente sin líneas, tintas ni pintura. Elige un dibujo, un grabado o una pintura.',
    'imitation-missing': 'No se pudo cargar la búsqueda de estilos. Comprueba la conexión e inténtalo de nuevo.',
    'worker-lost': 'Inkpanel falló al leer esta imagen. Prueba con otra.',
    'unreadable-file': 'El archivo se movió, cambió o borró desde que lo elegiste.',
    'unknown-format': 'No es una imagen que se pueda leer. Elige un archivo JPEG, PNG, WebP, AVIF, GIF, BMP o TIFF.',
    damaged: 'El archivo de esta imagen está dañado o incompleto.',
    'too-large': 'Esta imagen es demasiado grande.',
  } as Record<string, string>,
};
