// @ts-check
const count = (/** @type {number} */ n, /** @type {string} */ one) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const bookStrings = {
  book: {
    name: 'Páginas',
    page: (/** @type {number} */ n, /** @type {number} */ of) => `Página ${n} de ${of}`,
    add: 'Añadir página',
    addHelp: 'Añadir una página detrás de esta',
    addMore: (/** @type {number} */ left) => `Añadir una página: ${count(left, 'foto')} sin página aún`,
    tools: 'Herramientas de página',
    remove: 'Quitar página',
    earlier: 'Adelantar página',
    later: 'Atrasar página',
    spreadAlbum: 'Repartir el álbum en páginas',
    spreadHelp: (/** @type {number} */ n) => `Varias páginas con las ${n} fotos, en su orden`,
    styleAll: 'Usar este estilo en todas las páginas',
    left: (/** @type {number} */ n) => `${count(n, 'foto')} sin página`,
    reading: 'Las fotos aún se están leyendo.',
    removed: (/** @type {number} */ n) => `Se ha quitado la página ${n}.`,
    spread: (/** @type {number} */ photos, /** @type {number} */ pages) => `${count(photos, 'foto')} en ${count(pages, 'página')}.`,
    takeBack: 'Como estaba antes',
    dragHelp: 'Arrástrala para moverla, o Alt con una flecha',
  },
  version: (/** @type {number} */ n, /** @type {number} */ of) => `Versión ${n} de ${of} de esta página: ver todas las mostradas`,
  previousHelp: 'Versión anterior de esta página, como se mostró antes',
  nextHelp: 'Versión siguiente de esta página, como se mostró después',
  versionOf: (/** @type {number} */ n) => `de la página ${n}`,
};
