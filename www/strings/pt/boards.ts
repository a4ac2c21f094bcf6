/** Strings of the storyboard: shot list, sheets, import and export. */

export const boardsStrings = {
  boards: {
    seen: 'Exibição',
    comic: 'Quadrinhos',
    board: 'Storyboard',
    sheets: 'Folhas do storyboard',
    shots: 'Planos',
    picture: 'Imagem',
    order: 'Ordem',
    columns: { scene: 'Cena', number: 'Plano', length: 'Duração', action: 'Ação', dialogue: 'Diálogo', notes: 'Notas' },
    /** the columns of a list that is saved */
    heading: ['Cena', 'Plano', 'Imagem', 'Filme', 'Código de tempo', 'Duração', 'Quadros', 'Ação', 'Diálogo', 'Notas'],
    /** on the sheets; `{page}` and `{count}` become numbers */
    labels: { scene: 'Cena', dialogue: 'Diálogo', notes: 'Notas', page: 'Página {page} de {count}' },
    count: (count: number) => (count === 1 ? '1 plano' : `${count} planos`),
    shot: (number: string) => `plano ${number}`,
    up: (number: string) => `Subir o plano ${number}`,
    down: (number: string) => `Descer o plano ${number}`,
    help: 'Enter vai ao próximo plano, Tab ao próximo campo, Escape desiste do que foi digitado. Alt com as setas move um plano. As durações são segundos (2), segundos e quadros (2:12) ou quadros (36f). Células de uma planilha podem ser coladas.',
    followPages: 'Usar a ordem das páginas',
    dragHelp: 'Arraste para mudar de lugar.',
    copy: 'Copiar a tabela',
    copied: 'A lista foi copiada. Você pode colá-la em uma planilha.',
    newColumn: 'Nova coluna',
    addColumn: 'Adicionar coluna',
    removeColumn: (name: string) => `Remover a coluna ${name}`,
    noLength: (text: string) =>
      `“${text}” não é uma duração: escreva segundos (2), segundos e quadros (2:12) ou quadros (36f).`,
    pasteLost: (count: number) =>
      count === 1
        ? '1 célula colada ficou fora da tabela e foi ignorada.'
        : `${count} células coladas ficaram fora da tabela e foram ignoradas.`,
    filmBoard: 'Storyboard de filme',
    perSheet: 'Quadros por folha',
    aspect: 'Proporção',
    rate: 'Quadros por segundo',
    beside: 'Texto ao lado dos quadros',
    ruled: 'Folha de exercício: linhas para escrever',
    author: 'Autoria',
    date: 'Data',
    logo: 'Logotipo',
    chooseLogo: 'Escolher um logotipo',
    removeLogo: 'Remover o logotipo',
    logoFile: 'Imagem para o logotipo',
    noLogo: (name: string) =>
      `${name} não é uma imagem que o navegador consiga mostrar. Escolha um arquivo PNG, JPEG, WebP ou SVG.`,
    brokenLogo: 'O logotipo não pode ser lido. Remova-o ou escolha outro.',
    saveAs: 'Salvar como',
    saveBoard: 'Salvar o storyboard',
    ways: { pdf: 'Storyboard, PDF', zip: 'Storyboard, arquivos PNG em um ZIP' },
    importFile: 'Importar roteiro ou tabela',
    tooLarge: (name: string) => `${name} é grande demais para um roteiro ou uma tabela.`,
    nothingIn: (name: string) => `Nada em ${name} serve para os planos.`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name}: 1 plano foi preenchido.` : `${name}: ${count} planos foram preenchidos.`,
    quoted: (text: string) => `“${text}”`,
    left: (count: number, lines: string) =>
      count === 1
        ? `1 linha não corresponde a nenhum plano: ${lines}.`
        : `${count} linhas não correspondem a nenhum plano: ${lines}.`,
    cellsLeft: (count: number, cells: string) =>
      count === 1
        ? `1 célula foi omitida ou encurtada: ${cells}.`
        : `${count} células foram omitidas ou encurtadas: ${cells}.`,
    columnsLeft: (columns: string) => `O storyboard não tem lugar para estas colunas: ${columns}.`,
    noSheets: (why: string) => `O storyboard não pôde ser montado: ${why}`,
    missing: 'Não foi possível carregar o storyboard. Verifique a conexão e tente de novo.',
    sheet: (n: number, of: number) => `Folha ${n} de ${of}`,
    listSaved: 'A lista de planos foi salva.',
    listHelp: 'Todos os planos do álbum com seus dados, na ordem do storyboard.',
  },
};
