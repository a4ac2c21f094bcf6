/** The words about lettering by hand, scripts and subtitles. */

export const speechStrings = {
  wordResize: 'Cambiar el tamaño del texto',
  resizeKeys: 'Las flechas lo ensanchan o estrechan',
  wordTurn: 'Girar el texto',
  turnKeys: 'Las flechas lo giran un grado, con Mayús 15',
  wordMissing: (letters: string) =>
    `Ninguna fuente del programa ni de este dispositivo tiene estas letras; en lugar de cada una hay un signo de interrogación: ${letters}`,
  wordForeign: 'Algunas de estas letras se dibujan con una fuente de este dispositivo.',
  wordSlant: 'Inclinación',
  wordOutline: 'Contorno',
  wordCapitals: 'En mayúsculas',
  wordVertical: 'En columnas, de arriba abajo',
  wordJoin: 'Unir al bocadillo anterior',
  wordBoxless: 'Sin recuadro',
  wordBehind: 'Detrás de la figura',
  wordBehindWhy: 'Queda delante hasta que se conozca con claridad el motivo de la foto de la viñeta.',
  wordBar: 'Herramientas de rotulación',
  barWrite: 'Escribir',
  barTail: 'Ponerle rabillo',
  barSmaller: 'Letra más pequeña',
  barLarger: 'Letra más grande',
  barBold: 'Negrita',
  barCapitals: 'Mayúsculas',
  barVertical: 'En columnas',
  barArch: 'Arquear hacia arriba',
  barSag: 'Arquear hacia abajo',
  barLean: 'Inclinar',
  barOutline: 'Contorno grueso',
  barInk: 'Color de las letras',
  barFill: 'Color tras las letras',
  barDelete: 'Eliminar',
  script: 'Guion y subtítulos',
  scriptText: 'Guion o diálogo',
  scriptSample: 'ANA: ¿Dónde estamos?\nLEO: Ya casi.\n\nSFX: Splash',
  scriptHelp: 'Una línea por bocadillo, con NOMBRE: delante. Una línea vacía pasa a la viñeta siguiente.',
  putScript: 'Poner en bocadillos',
  soundsAsEffects: 'Sonidos como efectos',
  scriptLaid: (n: number) => (n === 1 ? 'Se puso 1 texto en las páginas.' : `Se pusieron ${n} textos en las páginas.`),
  speechSpread: (shown: number, total: number, unplaced: number, left: number) =>
    [
      `Se colocaron ${shown} de ${total} líneas; ${total - shown} no cabían.`,
      ...(unplaced > 0 ? [`${unplaced} ${unplaced === 1 ? 'está' : 'están'} en la lista de textos sin colocar.`] : []),
      ...(left > 0 ? [left === 1 ? 'Se omitió 1.' : `Se omitieron ${left}.`] : []),
    ].join(' '),
  scriptNoPage: 'todavía no hay página. Añade primero fotos.',
  scriptEmpty: 'no dice nada.',
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
  subtitlesGuessed: 'no está en UTF-8, así que se leyó como texto de Europa occidental (Windows-1252).',
  wordsWaiting: (n: number) => (n === 1 ? '1 texto sin colocar' : `${n} textos sin colocar`),
  wordsWaitingWhy:
    'Un texto vuelve cuando una página muestra otra vez su foto. Un texto sin foto se queda aquí hasta que lo pongas en una página.',
  putWaiting: (text: string) => `Poner en esta página: ${text}`,
  dropWaiting: (text: string) => `Descartar: ${text}`,
  dropAllWaiting: 'Descartar todos',
};
