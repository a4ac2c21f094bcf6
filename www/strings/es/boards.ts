/** Strings of the storyboard: shot list, sheets, import and export. */

export const boardsStrings = {
  boards: {
    seen: 'Vista',
    comic: 'Cómic',
    board: 'Storyboard',
    sheets: 'Hojas del storyboard',
    shots: 'Planos',
    picture: 'Imagen',
    order: 'Orden',
    columns: {
      scene: 'Escena',
      number: 'Plano',
      length: 'Duración',
      action: 'Acción',
      dialogue: 'Diálogo',
      notes: 'Notas',
    },
    /** the columns of a list that is saved */
    heading: [
      'Escena',
      'Plano',
      'Imagen',
      'Película',
      'Código de tiempo',
      'Duración',
      'Fotogramas',
      'Acción',
      'Diálogo',
      'Notas',
    ],
    /** on the sheets; `{page}` and `{count}` become numbers */
    labels: { scene: 'Escena', dialogue: 'Diálogo', notes: 'Notas', page: 'Página {page} de {count}' },
    count: (count: number) => (count === 1 ? '1 plano' : `${count} planos`),
    shot: (number: string) => `plano ${number}`,
    up: (number: string) => `Subir el plano ${number}`,
    down: (number: string) => `Bajar el plano ${number}`,
    help: 'Intro pasa al plano siguiente, Tab al campo siguiente y Escape descarta lo escrito. Alt con las flechas mueve un plano. Las duraciones son segundos (2), segundos y fotogramas (2:12) o fotogramas (36f). Se pueden pegar celdas de una hoja de cálculo.',
    followPages: 'Usar el orden de las páginas',
    dragHelp: 'Arrastra para moverlo.',
    copy: 'Copiar la tabla',
    copied: 'La lista se ha copiado. Puedes pegarla en una hoja de cálculo.',
    newColumn: 'Columna nueva',
    addColumn: 'Añadir columna',
    removeColumn: (name: string) => `Quitar la columna ${name}`,
    noLength: (text: string) =>
      `«${text}» no es una duración: escribe segundos (2), segundos y fotogramas (2:12) o fotogramas (36f).`,
    pasteLost: (count: number) =>
      count === 1
        ? '1 celda pegada quedaba fuera de la tabla y se ignoró.'
        : `${count} celdas pegadas quedaban fuera de la tabla y se ignoraron.`,
    filmBoard: 'Storyboard de cine',
    perSheet: 'Viñetas por hoja',
    aspect: 'Proporción',
    rate: 'Fotogramas por segundo',
    beside: 'Texto junto a las viñetas',
    ruled: 'Ficha: líneas para escribir',
    author: 'Autoría',
    date: 'Fecha',
    logo: 'Logotipo',
    chooseLogo: 'Elegir un logotipo',
    removeLogo: 'Quitar el logotipo',
    logoFile: 'Imagen para el logotipo',
    noLogo: (name: string) =>
      `${name} no es una imagen que el navegador pueda mostrar. Elige un archivo PNG, JPEG, WebP o SVG.`,
    brokenLogo: 'No se puede leer el logotipo. Quítalo o elige otro.',
    saveAs: 'Guardar como',
    saveBoard: 'Guardar el storyboard',
    ways: { pdf: 'Storyboard, PDF', zip: 'Storyboard, archivos PNG en un ZIP' },
    importFile: 'Importar guion o tabla',
    tooLarge: (name: string) => `${name} es demasiado grande para un guion o una tabla.`,
    nothingIn: (name: string) => `Nada de ${name} encaja con los planos.`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name}: se rellenó 1 plano.` : `${name}: se rellenaron ${count} planos.`,
    quoted: (text: string) => `«${text}»`,
    left: (count: number, lines: string) =>
      count === 1
        ? `1 línea no corresponde a ningún plano: ${lines}.`
        : `${count} líneas no corresponden a ningún plano: ${lines}.`,
    cellsLeft: (count: number, cells: string) =>
      count === 1
        ? `1 celda se omitió o se acortó: ${cells}.`
        : `${count} celdas se omitieron o se acortaron: ${cells}.`,
    columnsLeft: (columns: string) => `En el storyboard no caben estas columnas: ${columns}.`,
    noSheets: (why: string) => `No se pudo componer el storyboard: ${why}`,
    missing: 'No se pudo cargar el storyboard. Comprueba la conexión e inténtalo de nuevo.',
    sheet: (n: number, of: number) => `Hoja ${n} de ${of}`,
    listSaved: 'La lista de planos se guardó.',
    listHelp: 'Todos los planos del álbum con sus datos, en el orden del storyboard.',
  },
};
