const count = (n: number, one: string) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const bookStrings = {
  book: {
    name: 'Páginas',
    page: (n: number, of: number) => `Página ${n} de ${of}`,
    add: 'Añadir página',
    addHelp: 'Añadir una página detrás de esta',
    addMore: (left: number) => `Añadir una página: ${count(left, 'foto')} sin página aún`,
    tools: 'Herramientas de página',
    remove: 'Quitar página',
    earlier: 'Adelantar página',
    later: 'Atrasar página',
    spreadAlbum: 'Repartir el álbum en páginas',
    spreadHelp: (n: number) => `Varias páginas con las ${n} fotos, en su orden`,
    styleAll: 'Usar este estilo en todas las páginas',
    left: (n: number) => `${count(n, 'foto')} sin página`,
    reading: 'Las fotos aún se están leyendo.',
    removed: (n: number) => `Se ha quitado la página ${n}.`,
    spread: (photos: number, pages: number) => `${count(photos, 'foto')} en ${count(pages, 'página')}.`,
    takeBack: 'Como estaba antes',
    dragHelp: 'Arrástrala para moverla, o Alt con una flecha',
  },
  version: (n: number, of: number) => `Versión ${n} de ${of} de esta página: ver todas las mostradas`,
  previousHelp: 'Versión anterior de esta página, como se mostró antes',
  nextHelp: 'Versión siguiente de esta página, como se mostró después',
  versionOf: (n: number) => `de la página ${n}`,
};
