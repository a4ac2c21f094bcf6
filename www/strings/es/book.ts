const count = (n: number, one: string) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const bookStrings = {
  book: {
    name: 'Páginas',
    page: (n: number, of: number) => `Página ${n} de ${of}`,
    add: 'Añadir página',
    addHelp: 'Insertar una página después de esta',
    addMore: (left: number) => `Añadir una página: ${count(left, 'foto')} sin página aún`,
    tools: 'Herramientas de página',
    remove: 'Quitar página',
    turnBack: 'Página anterior',
    turnOn: 'Página siguiente',
    earlier: 'Adelantar página',
    later: 'Atrasar página',
    make: 'Crear un libro',
    makeHelp: (n: number) => `Portada, capítulos por día, textos y números de página, con tus ${n} fotos`,
    makeChapters: 'Crear un libro, un estilo por día',
    makeChaptersHelp: 'Como «Crear un libro», con otro estilo para cada día',
    made: (n: number) => `Tu libro tiene ${n} páginas.`,
    looking: 'Mirando tus fotos…',
    making: (done: number, of: number) => `Página ${done + 1} de ${of}…`,
    spreadAlbum: 'Hacer páginas con todas las fotos',
    spreadHelp: (n: number) => `Varias páginas con las ${n} fotos, en su orden`,
    spreadAsk: 'Las páginas nuevas reemplazan las tuyas, también lo que cambiaste a mano.',
    spreadYes: 'Reemplazar páginas',
    styleAll: 'Usar este estilo en todas las páginas',
    left: (n: number) => `${count(n, 'foto')} sin página`,
    reading: 'Las fotos aún se están leyendo.',
    removed: (n: number) => `Se ha quitado la página ${n}.`,
    spread: (photos: number, pages: number) => `${count(photos, 'foto')} en ${count(pages, 'página')}.`,
    repeats: (n: number) =>
      n === 1
        ? 'No hay suficientes fotos sin usar. Esta página repite 1 foto.'
        : `No hay suficientes fotos sin usar. Esta página repite ${n} fotos.`,
    takeBack: 'Restaurar páginas',
    dragHelp: 'Arrástrala para moverla, o Alt con una flecha',
  },
  version: (n: number, of: number) => `Versión ${n} de ${of} de esta página: mostrar todas las versiones`,
  previousHelp: 'Mostrar la versión anterior de esta página',
  nextHelp: 'Mostrar la versión siguiente de esta página',
};
