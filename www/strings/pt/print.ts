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
    safeHelp: 'Nada é cortado dentro desta linha. A linha não é exportada.',
    bleed: 'Sangria',
    bleeds: {
      none: 'Nenhuma',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 pol.',
    },
    bleedHelp:
      'Os quadros da borda se estendem até a sangria, para que não apareça borda branca no corte. Com margem, a sangria tem a cor do papel.',
    marks: 'Marcas de corte',
    sheets: 'Folhas',
    impositions: {
      none: 'Uma página por folha',
      booklet: 'Livreto para dobrar e grampear',
      zine: 'Minizine, oito páginas de uma folha',
      twoUp: 'Duas páginas por folha, para separar',
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
    plates: 'Separações de cores especiais (riso, serigrafia)',
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
    enlarge: 'Ampliar fotos de baixa resolução',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'A foto deste quadro é ampliada com contornos mais nítidos. A ampliação não acrescenta detalhes.'
        : `As fotos destes ${n} quadros são ampliadas com contornos mais nítidos. A ampliação não acrescenta detalhes.`,
    coarseMark: (dpi: number) => `${dpi} dpi`,
    coarseHelp: 'Mostre a foto menor ou menos cortada, ou use uma maior.',
    coarseHide: 'Esconder os avisos de resolução',
  },
};
