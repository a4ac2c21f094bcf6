/** Palabras de la impresión: pliegos, sangrado, planchas y la revisión previa. */

export const printStrings = {
  print: {
    moreSizes: 'Más tamaños',
    purpose: {
      paper: 'Papel',
      book: 'Libros',
      screen: 'Pantallas',
    },
    showSafe: 'Mostrar área segura',
    safeHelp: 'Lo que está dentro de esta línea no se corta. La línea no se exporta.',
    bleed: 'Sangrado',
    bleeds: {
      none: 'Ninguno',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 pulg.',
    },
    bleedHelp:
      'Las viñetas del borde se extienden hasta el sangrado, para que no quede un borde blanco al cortar. Con margen, el sangrado tiene el color del papel.',
    marks: 'Marcas de corte',
    sheets: 'Pliegos',
    impositions: {
      none: 'Una página por hoja',
      booklet: 'Cuadernillo para doblar y grapar',
      zine: 'Minifanzine, ocho páginas de una hoja',
      twoUp: 'Dos páginas por hoja, para separar',
      spreads: 'Dobles páginas',
    },
    booklet: 'Imprime a doble cara, girando por el borde corto. Dobla una vez y grapa por el pliegue.',
    zine: 'Imprime a una cara. Dobla en octavos, corta el centro por el pliegue y junta.',
    twoUp: 'Imprime y corta entre las páginas.',
    spreads: 'La primera página sola, luego de dos en dos como un libro abierto.',
    blanks: (n: number) => `${n === 1 ? 'Una página queda' : `${n} páginas quedan`} en blanco.`,
    paperSize: 'Papel',
    papers: {
      none: 'Del tamaño de las páginas',
      a4: 'A4',
      a3: 'A3',
      letter: 'Carta',
      tabloid: 'Tabloide',
    },
    plates: 'Separaciones de tintas planas (riso, serigrafía)',
    platesHelp: 'Un PDF gris por cada tinta, juntos en un ZIP.',
    inks: {
      red: 'rojo',
      blue: 'azul',
      pink: 'rosa',
      teal: 'verde azulado',
      orange: 'naranja',
      navy: 'azul marino',
      coral: 'coral',
      green: 'verde',
      yellow: 'amarillo',
      cyan: 'cian',
      magenta: 'magenta',
      violet: 'violeta',
      black: 'negro',
    },
    coarse: (n: number, dpi: number) =>
      `${n === 1 ? 'Una viñeta tiene' : `${n} viñetas tienen`} menos de ${dpi} ppp a este tamaño; impreso puede verse borroso:`,
    coarsePanel: (n: number, dpi: number) => `Viñeta ${n}: ${dpi} ppp`,
    coarseOn: (page: number, n: number, dpi: number) => `Página ${page}, viñeta ${n}: ${dpi} ppp`,
    coarseMore: (n: number) => `y ${n} más`,
    enlarge: 'Ampliar fotos de baja resolución',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'La foto de esta viñeta se amplía con bordes más nítidos. La ampliación no añade detalle.'
        : `Las fotos de estas ${n} viñetas se amplían con bordes más nítidos. La ampliación no añade detalle.`,
    coarseMark: (dpi: number) => `${dpi} ppp`,
    coarseHelp: 'Muestra la foto más pequeña o menos recortada, o usa una más grande.',
    coarseHide: 'Ocultar los avisos de resolución',
  },
};
