export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}: ${why}`,
  filesFailed: (n: number) => `No se han podido leer ${n} archivos.`,
  showList: 'Ver la lista',
  moreFiles: (n: number) => `y ${n} más`,
  /** The core's own sentences are English, so all its codes are here. */
  reasons: {
    'worker-lost': 'al leerlo se detuvo el programa dos veces, así que se ha dejado fuera.',
    'unreadable-file': 'el archivo se movió, cambió o borró después de elegirlo.',
    'unknown-format': 'no es una imagen que Inkpanel sepa leer (JPEG, PNG, WebP, GIF, BMP o TIFF).',
    damaged: 'el archivo está dañado o incompleto.',
    unsupported: 'este tipo de archivo no se puede leer.',
    'too-large': 'es demasiado grande.',
    'no-decoder':
      'este navegador no sabe leer este tipo de foto. Guárdala como JPEG o abre esta página en otro navegador.',
    'no-room': 'el navegador no tiene sitio para la foto.',
    'missing-photo': 'la foto no está cargada.',
    'no-photos': 'no hay ninguna foto que se pueda usar.',
    encode: 'la página no se pudo codificar.',
    'video-codec': 'este navegador no sabe descodificar el vídeo.',
    'video-decoder': 'este navegador no sabe descodificar el vídeo.',
    'video-format': 'no es un vídeo MP4, MOV, WebM o Matroska completo.',
    'video-empty': 'no tiene imagen, solo sonido.',
    'video-memory': 'no hay memoria suficiente para un fotograma.',
    'video-worker': 'el lector del vídeo se detuvo.',
    'words-missing': 'no se pudieron cargar las letras.',
    'decoders-missing': 'no se pudo cargar lo que lee estas fotos. Inténtalo de nuevo con conexión.',
    'core-missing': 'no se pudo cargar el programa.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: number) =>
    `${n === 1 ? '1 archivo no se añadió' : `${n} archivos no se añadieron`}: en un proyecto caben ${most.toLocaleString('es', { useGrouping: 'always' })} fotos.`,
  noUsablePhoto:
    'No se pudo usar ninguno de estos archivos. Elige fotos JPEG, PNG, WebP, AVIF, GIF, BMP o TIFF, o un vídeo.',
  noSamples: 'No se pudo cargar el álbum de muestra. Comprueba la conexión e inténtalo otra vez.',
  noPhotosInUse: 'No hay ninguna foto en uso. Marca una en Fotos para tener una página.',
  panelFailed: (why: string) => `No se pudo dibujar una viñeta: ${why}`,
  coreFailed: (why: string) => `Inkpanel no pudo arrancar: ${why}`,
  locked: { layout: 'La plantilla está fijada.', style: 'El estilo está fijado.', photos: 'Las fotos están fijadas.' },
};
