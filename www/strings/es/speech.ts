/** Strings of lettering tools, scripts and subtitles. */

export const speechStrings = {
  wordResize: 'Cambiar el tamaño del texto',
  resizeKeys: 'Las flechas lo ensanchan o estrechan',
  wordTurn: 'Girar el texto',
  turnKeys: 'Las flechas lo giran un grado, con Mayús 15',
  wordMissing: (letters: string) =>
    `Ninguna fuente tiene estos caracteres, así que aparecen como signos de interrogación: ${letters}`,
  wordForeign: 'Algunos caracteres usan una fuente de este dispositivo.',
  wordSlant: 'Inclinación',
  wordOutline: 'Contorno',
  wordCapitals: 'En mayúsculas',
  wordVertical: 'Texto vertical',
  wordJoin: 'Enlazar con el bocadillo anterior',
  wordBoxless: 'Sin recuadro',
  wordBehind: 'Detrás del motivo',
  wordBehindWhy: 'El texto queda delante hasta que la foto tenga una máscara clara del motivo.',
  wordBar: 'Herramientas de rotulación',
  barSmaller: 'Texto más pequeño',
  barLarger: 'Texto más grande',
  script: 'Guion y subtítulos',
  scriptText: 'Guion o diálogo',
  scriptSample: 'ANA: ¿Dónde estamos?\nLEO: Ya casi.\n\nSFX: Splash',
  scriptHelp:
    'Una línea por bocadillo, con NOMBRE: delante. Una línea vacía pasa a la viñeta siguiente, y una línea como VIÑETA 3 a esa viñeta.',
  putScript: 'Crear bocadillos',
  soundsAsEffects: 'Sonidos como efectos',
  scriptLaid: (n: number) => (n === 1 ? 'Se puso 1 texto en las páginas.' : `Se pusieron ${n} textos en las páginas.`),
  speechSpread: (shown: number, total: number, unplaced: number, left: number) =>
    [
      `Se colocaron ${shown} de ${total} líneas; ${total - shown} no cabían.`,
      ...(unplaced > 0 ? [`${unplaced} ${unplaced === 1 ? 'está' : 'están'} en la lista de textos sin colocar.`] : []),
      ...(left > 0 ? [left === 1 ? 'Se omitió 1.' : `Se omitieron ${left}.`] : []),
    ].join(' '),
  scriptNoPage: 'todavía no hay página. Añade primero fotos.',
  scriptEmpty: 'no tiene diálogo.',
  scriptOffered: (names: string) => `${names} puede ser un guion. No se puso en las páginas.`,
  scriptFailed: (why: string) => `El guion no se puso en la página: ${why}`,
  subtitlesLaid: (shown: number, waiting: number, homeless: number) =>
    [
      shown === 1 ? 'Se puso 1 texto en las páginas.' : `Se pusieron ${shown} textos en las páginas.`,
      ...(waiting > 0
        ? [`${waiting} ${waiting === 1 ? 'espera' : 'esperan'} fotogramas que ninguna página muestra.`]
        : []),
      ...(homeless > 0
        ? [`${homeless} no ${homeless === 1 ? 'encontró' : 'encontraron'} un fotograma cercano con sitio.`]
        : []),
    ].join(' '),
  subtitlesThere: 'todos sus subtítulos están ya puestos.',
  subtitlesSkipped: (n: number, why: readonly string[]) =>
    `${n === 1 ? 'se omitió un subtítulo' : `se omitieron ${n} subtítulos`}: ${why.join(' ')}`,
  textGuessed: (encoding: string) => `no está en UTF-8, así que su texto se leyó como ${encoding}.`,
  textLost: (n: number) => (n === 1 ? 'No se pudo leer 1 carácter.' : `No se pudieron leer ${n} caracteres.`),
  changeEncoding: 'Cambiar codificación',
  encodingOf: (name: string) => `Codificación de ${name}`,
  encoding: 'Codificación',
  encodingPreview: 'Vista previa',
  readAgain: 'Leer de nuevo',
  wordsWaiting: (n: number) => (n === 1 ? '1 texto sin colocar' : `${n} textos sin colocar`),
  wordsWaitingWhy:
    'Un texto vuelve cuando una página muestra otra vez su foto. Un texto sin foto se queda aquí hasta que lo pongas en una página.',
  putWaiting: (text: string) => `Poner en esta página: ${text}`,
  dropWaiting: (text: string) => `Descartar: ${text}`,
  dropAllWaiting: 'Descartar todos',
};
