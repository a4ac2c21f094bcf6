export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}: ${why}`,
  filesFailed: (n: number) => `No se han podido leer ${n} archivos.`,
  internalError: (what: string) => `se produjo un error interno: ${what}`,
  showList: 'Ver la lista',
  moreFiles: (n: number) => `y ${n} más`,
  /** The core's own sentences are English, so all its codes are here. */
  reasons: {
    'animatic-encoder': 'el navegador dejó de codificarla. Elige un tamaño menor u otro tipo de archivo.',
    'animatic-long': 'un archivo GIF dura un minuto como mucho. Elige MP4 o WebM, o planos más cortos.',
    'animatic-sound': 'este navegador no codifica sonido para ese archivo. Elige WebM o quita el sonido.',
    'sound-unread': 'el navegador no puede leer el sonido. Conviértelo a MP3 o WAV.',
    'film-cut': 'el archivo está incompleto (falta su índice). Cópialo otra vez desde el original.',
    'film-empty': 'el vídeo no tiene fotogramas.',
    'films-missing': 'no se pudo cargar el lector de vídeo. Comprueba la conexión e inténtalo de nuevo.',
    'texts-missing': 'no se pudo cargar el lector de archivos de texto. Comprueba la conexión e inténtalo de nuevo.',
    'worker-lost': 'Inkpanel falló dos veces al leerlo, así que se omitió.',
    'unreadable-file': 'el archivo se movió, cambió o borró después de elegirlo.',
    'not-text': 'no es un archivo de texto, o su codificación es desconocida. Guárdalo como UTF-8.',
    'unreadable-entry': 'el navegador no puede leerlo. Quizá solo está en la nube o es un enlace roto.',
    'unreadable-folder': 'el navegador no puede leer todos los archivos de esta carpeta.',
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
    'files-missing': 'no se pudo cargar lo que crea este tipo de archivo. Inténtalo de nuevo o guarda un PNG.',
    'decoders-missing': 'no se pudo cargar lo que lee estas fotos. Inténtalo de nuevo con conexión.',
    'painters-missing': 'no se pudieron cargar los pintores. Inténtalo de nuevo con conexión.',
    'core-missing': 'no se pudo cargar el programa.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n === 1 ? '1 archivo no se añadió' : `${n} archivos no se añadieron`}: en un proyecto caben ${most} fotos.`,
  /** Reasons by error code that name the kind of file. */
  reasonsOf: {
    'film-container': (what: string) =>
      `Inkpanel no puede leer este formato de vídeo (${what}). Conviértelo a MP4 con vídeo H.264, por ejemplo con HandBrake o ffmpeg.`,
    'film-codec': (what: string) =>
      `este navegador no puede descodificar vídeo ${what}. Conviértelo a MP4 con vídeo H.264, por ejemplo con HandBrake o ffmpeg.`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) => `${name}: el ${share} de la imagen está dañado y se dibuja en gris.`,
  photoCoarse: (name: string, share: string) =>
    `${name}: al ${share} de la imagen le falta detalle, porque el archivo está dañado o incompleto.`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name} está incompleto: termina en ${till} de ${whole}. Todos los fotogramas son de esa parte.`,
  noUsablePhoto:
    'No se pudo usar ninguno de estos archivos. Elige fotos JPEG, PNG, WebP, AVIF, GIF, BMP o TIFF, o un vídeo.',
  noSamples: 'No se pudo cargar el álbum de muestra. Comprueba la conexión e inténtalo otra vez.',
  noPhotosInUse: 'No hay ninguna foto en uso. Marca una en Fotos para tener una página.',
  panelFailed: (why: string) => `No se pudo dibujar una viñeta: ${why}`,
  partMissing: 'No se pudo cargar esta parte de Inkpanel. Comprueba la conexión e inténtalo de nuevo.',
  notDone: (why: string) => `Esto no se pudo hacer: ${why}`,
  coreFailed: (why: string) => `Inkpanel no pudo arrancar: ${why}`,
  locked: { layout: 'La plantilla está fijada.', style: 'El estilo está fijado.', photos: 'Las fotos están fijadas.' },
};
