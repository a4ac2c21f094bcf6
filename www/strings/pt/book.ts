const photos = (n: number) => (n < 2 ? `${n} foto` : `${n} fotos`);
const pages = (n: number) => (n < 2 ? `${n} página` : `${n} páginas`);

export const bookStrings = {
  book: {
    name: 'Páginas',
    page: (n: number, of: number) => `Página ${n} de ${of}`,
    add: 'Adicionar página',
    addHelp: 'Inserir uma página depois desta',
    addMore: (left: number) => `Adicionar uma página: ${photos(left)} ainda em nenhuma página`,
    tools: 'Ferramentas de página',
    remove: 'Remover página',
    turnBack: 'Página anterior',
    turnOn: 'Próxima página',
    earlier: 'Mover página para antes',
    later: 'Mover página para depois',
    make: 'Criar um livro',
    makeHelp: (n: number) => `Capa, capítulos por dia, legendas e números de página, com as suas ${n} fotos`,
    makeChapters: 'Criar um livro, um estilo por dia',
    makeChaptersHelp: 'Como “Criar um livro”, com outro estilo para cada dia',
    made: (n: number) => `O seu livro tem ${n} páginas.`,
    looking: 'A ver as suas fotos…',
    making: (done: number, of: number) => `Página ${done + 1} de ${of}…`,
    spreadAlbum: 'Fazer páginas com todas as fotos',
    spreadHelp: (n: number) => `Várias páginas com todas as ${n} fotos, na ordem delas`,
    spreadAsk: 'As páginas novas substituem as suas, também o que você mudou à mão.',
    spreadYes: 'Substituir páginas',
    styleAll: 'Usar este estilo em todas as páginas',
    left: (n: number) => `${photos(n)} em nenhuma página`,
    reading: 'As fotos ainda estão sendo lidas.',
    removed: (n: number) => `A página ${n} foi removida.`,
    spread: (n: number, on: number) => `${photos(n)} em ${pages(on)}.`,
    repeats: (n: number) =>
      n === 1
        ? 'Não há fotos sem uso suficientes. Esta página repete 1 foto.'
        : `Não há fotos sem uso suficientes. Esta página repete ${n} fotos.`,
    takeBack: 'Restaurar páginas',
    dragHelp: 'Arraste para mover, ou Alt com uma seta',
  },
  version: (n: number, of: number) => `Versão ${n} de ${of} desta página: mostrar todas as versões`,
  previousHelp: 'Mostrar a versão anterior desta página',
  nextHelp: 'Mostrar a próxima versão desta página',
};
