/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Estilo de una imagen',
  styleFromPictureHelp: 'Lleva a tus fotos el aspecto de una imagen: una página de cómic, un grabado o una pintura',
  imitationAbout:
    'Elige una imagen cuyo aspecto quieras: una página de cómic, un grabado, un dibujo, una pintura. En pocos segundos se buscan estilos que den ese aspecto a tu propia foto. La imagen no sale de este dispositivo.',
  imitationDrop: 'También puedes soltar una imagen en cualquier lugar con la tecla Alt pulsada.',
  imitationChoose: 'Elegir una imagen',
  imitationOther: 'Otra imagen',
  imitationFile: 'Imagen cuyo estilo se busca',
  imitationAgain: 'Buscar de nuevo',
  imitationAnyway: 'Buscar de todos modos',
  imitating: 'Buscando estilos…',
  imitationProposals: 'Estilos encontrados',
  imitationPhotos: 'Foto en la que probarlos',
  imitationNone: 'Ningún estilo se acercó a esta imagen. Prueba con otra.',
  imitationNeedsPhotos: 'Elige primero fotos: el estilo de una imagen se prueba en una de ellas.',
  dropForStyle: 'Suelta aquí, o con Alt pulsada, para tomar el estilo de una imagen',
  imitationFound: (n: number) =>
    n === 1
      ? '1 estilo encontrado. Es tuyo cuando lo usas, lo editas o lo guardas.'
      : `${n} estilos encontrados. Uno es tuyo cuando lo usas, lo editas o lo guardas.`,
  imitationName: (picture: string, place: number) => `Como ${picture} ${place}`,
  imitationPictureOf: (name: string) => `La imagen ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Esta imagen es demasiado pequeña para leer un estilo: cada lado necesita 64 píxeles.',
    'blank-picture': 'Esta imagen está vacía: no hay ningún estilo en ella.',
    'plain-photo':
      'Parece una foto corriente: no hay líneas, tintas ni pintura que tomar. Elige un dibujo, un grabado o una pintura.',
    'imitation-missing': 'No se pudo cargar lo que busca estilos en imágenes. Inténtalo de nuevo con conexión.',
    'worker-lost': 'Al leer esta imagen el programa se detuvo. Prueba con otra.',
    'unreadable-file': 'El archivo se movió, cambió o borró desde que lo elegiste.',
    'unknown-format': 'No es una imagen que se pueda leer. Elige un archivo JPEG, PNG, WebP, AVIF, GIF, BMP o TIFF.',
    damaged: 'El archivo de esta imagen está dañado o incompleto.',
    'too-large': 'Esta imagen es demasiado grande.',
  } as Record<string, string>,
};
