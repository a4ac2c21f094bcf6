/** Palavras da impressão: folhas, sangria, chapas e a verificação antes dela. */

export const printStrings = {
  print: {
    moreSizes: 'Mais tamanhos',
    purpose: {
      paper: 'Papel',
      book: 'Livros',
      screen: 'Telas',
    },
    showSafe: 'Mostrar área segura',
    safeHelp: 'Rostos e palavras dentro da linha nunca são cortados. Ela não está em nenhum arquivo.',
    bleed: 'Sangria',
    bleeds: {
      none: 'Nenhuma',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 pol.',
    },
    bleedHelp:
      'Os quadros da borda continuam além dela, para que não apareça branco no corte. Com margem, há ali a cor do papel.',
    marks: 'Marcas de corte',
    sheets: 'Folhas',
    impositions: {
      none: 'Uma página cada',
      booklet: 'Livreto para dobrar e grampear',
      zine: 'Minizine, oito páginas de uma folha',
      twoUp: 'Duas páginas para separar',
      spreads: 'Páginas duplas',
    },
    booklet: 'Imprima frente e verso, virando pela borda curta. Dobre uma vez e grampeie na dobra.',
    zine: 'Imprima de um lado. Dobre em oito, corte o meio ao longo da dobra e junte.',
    twoUp: 'Imprima e corte entre as páginas.',
    spreads: 'A primeira página sozinha, depois duas a duas como um livro aberto.',
    blanks: (n: number) => `${n === 1 ? 'Uma página fica' : `${n} páginas ficam`} em branco.`,
    paperSize: 'Papel',
    papers: {
      none: 'Do tamanho das páginas',
      a4: 'A4',
      a3: 'A3',
      letter: 'Carta',
      tabloid: 'Tabloide',
    },
    plates: 'Chapas para riso ou serigrafia',
    platesHelp: 'Um PDF cinza para cada tinta, juntos em um ZIP.',
    inks: {
      red: 'vermelho',
      blue: 'azul',
      pink: 'rosa',
      teal: 'azul-petróleo',
      orange: 'laranja',
      navy: 'azul-marinho',
      coral: 'coral',
      green: 'verde',
      yellow: 'amarelo',
      cyan: 'ciano',
      magenta: 'magenta',
      violet: 'violeta',
      black: 'preto',
    },
    coarse: (n: number, dpi: number) =>
      `${n === 1 ? 'Um quadro tem' : `${n} quadros têm`} menos de ${dpi} dpi neste tamanho; impresso pode parecer borrado:`,
    coarsePanel: (n: number, dpi: number) => `Quadro ${n}: ${dpi} dpi`,
    coarseOn: (page: number, n: number, dpi: number) => `Página ${page}, quadro ${n}: ${dpi} dpi`,
    coarseMore: (n: number) => `e mais ${n}`,
    enlarge: 'Ampliar bem',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'A foto deste quadro é ampliada com contornos mais nítidos. Não ganha detalhes que não tem.'
        : `As fotos destes ${n} quadros são ampliadas com contornos mais nítidos. Não ganham detalhes que não têm.`,
    coarseMark: (dpi: number) => `${dpi} dpi`,
    coarseHelp: 'Mostre a foto menor ou menos cortada, ou use uma maior.',
    coarseHide: 'Esconder as marcas',
  },
};
