type Kind = 'caption' | 'balloon' | 'effect';

export const wordStrings = {
  words: 'Texto',
  addWord: { caption: 'Añadir cartela', balloon: 'Añadir bocadillo', effect: 'Añadir onomatopeya' },
  wordShort: { caption: 'Cartela', balloon: 'Bocadillo', effect: 'Sonido' },
  /** Text of a new item. */
  wordSample: { caption: 'Mientras tanto…', balloon: '¡Hola!', effect: '¡PUM!' },
  wordKind: { caption: 'Cartela', balloon: 'Bocadillo', effect: 'Onomatopeya' },
  word: (kind: Kind, text: string) => `${wordStrings.wordKind[kind]}: ${text}`,
  wordKeys: 'Intro edita el texto, las flechas lo mueven, Supr lo quita',
  wordText: (name: string) => `Texto de ${name}`,
  wordTail: (name: string) => `Rabillo de ${name}`,
  tailKeys: 'Las flechas mueven la punta del rabillo',
  wordList: 'Texto de la página',
  narration: 'Título y textos',
  narrationHelp: 'Las páginas nuevas llevan el nombre del álbum y textos con fechas, horas y lugares.',
  noWords: 'Aún no hay texto.',
  shape: 'Forma',
  shapes: { oval: 'Habla', thought: 'Pensamiento', shout: 'Grito', whisper: 'Susurro', radio: 'Radio' },
  editWord: 'Editar texto',
  formatWord: 'Formato',
  moveWord: 'Mover a…',
  pointTail: 'Apuntar el rabillo a…',
  removeTail: 'Quitar rabillo',
  placeWord: 'Posición automática',
  removeWord: 'Quitar texto',
  wordX: 'X',
  wordY: 'Y',
  wordWidth: 'Ancho',
  wordSize: 'Tamaño',
  wordAuto: 'automático',
  wordAngle: 'Ángulo',
  wordArc: 'Arco',
  wordColor: 'Color',
  wordFill: 'Relleno',
  wordFont: 'Tipo de letra',
  fonts: { 'comic-neue': 'Comic Neue', 'comic-neue-bold': 'Comic Neue negrita', bangers: 'Bangers' },
  wordCut: 'El texto no cabía y se cortó.',
  wordModes: { move: 'Pulsa donde va', tail: 'Pulsa a qué apunta' },
  wordRemoved: (name: string) => `Se ha quitado ${name}.`,
  wordsFull: (most: number) => `Una página puede tener como máximo ${most} textos. Quita alguno antes de añadir más.`,
  wordsFailed: (why: string) => `No se pudo dibujar el texto: ${why}`,

  // Subtitles
  addSubtitles: 'Añadir subtítulos',
  subtitlesFile: 'Archivo de subtítulos',
  subtitlesAs: 'Como',
  subtitlesKinds: { caption: 'Cartelas', balloon: 'Bocadillos' },
  subtitlesNoFrames: 'todavía no hay página. Añade primero fotos o el vídeo.',
  subtitlesNoMatch: 'ningún subtítulo está cerca del momento de un fotograma.',
  subtitlesLeft: (n: number, of: number) =>
    `se han leído ${of} subtítulos; ${n} más son demasiados y se han dejado fuera.`,
  subtitlesCut: (n: number) =>
    n === 1
      ? 'un subtítulo es demasiado largo, así que se ha dejado fuera su final.'
      : `${n} subtítulos son demasiado largos, así que se han dejado fuera sus finales.`,
  subtitleErrors: {
    empty: 'no contiene subtítulos.',
    binary: 'no es un texto que se pueda leer.',
    large: 'pasa de 5 MB.',
    time: (line: number, text: string) =>
      `línea ${line}: «${text}» no es un tiempo como 00:01:02,500 --> 00:01:04,000.`,
    order: (line: number) => `línea ${line}: el subtítulo acaba antes de empezar.`,
    header: 'no empieza por WEBVTT.',
    stray: (line: number, text: string) => `línea ${line}: se esperaba un tiempo, no «${text}».`,
  },
};
