/** Strings of lettering tools, scripts and subtitles. */

export const speechStrings = {
  wordResize: 'Redimensionar o texto',
  resizeKeys: 'As setas alargam ou estreitam',
  wordTurn: 'Girar o texto',
  turnKeys: 'As setas giram um grau, com Shift 15',
  wordMissing: (letters: string) =>
    `Nenhuma fonte tem estes caracteres, por isso aparecem como pontos de interrogação: ${letters}`,
  wordForeign: 'Alguns caracteres usam uma fonte deste aparelho.',
  wordSlant: 'Inclinação',
  wordOutline: 'Contorno',
  wordCapitals: 'Em maiúsculas',
  wordVertical: 'Texto vertical',
  wordJoin: 'Ligar ao balão anterior',
  wordBoxless: 'Sem caixa',
  wordBehind: 'Atrás do assunto',
  wordBehindWhy: 'O texto fica à frente até que a foto tenha uma máscara clara do assunto.',
  wordBar: 'Ferramentas de letreiramento',
  barSmaller: 'Texto menor',
  barLarger: 'Texto maior',
  script: 'Roteiro e legendas',
  scriptText: 'Roteiro ou diálogo',
  scriptSample: 'ANA: Onde estamos?\nLEO: Quase lá.\n\nSFX: Splash',
  scriptHelp:
    'Uma linha por balão, com NOME: na frente. Uma linha vazia passa ao quadro seguinte, e uma linha como QUADRO 3 a esse quadro.',
  putScript: 'Criar balões',
  soundsAsEffects: 'Sons como efeitos',
  scriptLaid: (n: number) => (n === 1 ? '1 texto foi posto nas páginas.' : `${n} textos foram postos nas páginas.`),
  speechSpread: (shown: number, total: number, unplaced: number, left: number) =>
    [
      `${shown} de ${total} linhas foram colocadas; ${total - shown} não couberam.`,
      ...(unplaced > 0
        ? [`${unplaced} ${unplaced === 1 ? 'está' : 'estão'} na lista de textos não posicionados.`]
        : []),
      ...(left > 0 ? [left === 1 ? '1 ficou de fora.' : `${left} ficaram de fora.`] : []),
    ].join(' '),
  scriptNoPage: 'ainda não há página. Adicione fotos primeiro.',
  scriptEmpty: 'não há diálogo nele.',
  scriptOffered: (names: string) => `${names} pode ser um roteiro. Não foi posto nas páginas.`,
  scriptFailed: (why: string) => `O roteiro não foi posto na página: ${why}`,
  subtitlesLaid: (shown: number, waiting: number, homeless: number) =>
    [
      shown === 1 ? '1 texto foi posto nas páginas.' : `${shown} textos foram postos nas páginas.`,
      ...(waiting > 0 ? [`${waiting} ${waiting === 1 ? 'espera' : 'esperam'} imagens que nenhuma página mostra.`] : []),
      ...(homeless > 0
        ? [`${homeless} não ${homeless === 1 ? 'achou' : 'acharam'} uma imagem próxima com espaço.`]
        : []),
    ].join(' '),
  subtitlesThere: 'todas as suas legendas já estão lá.',
  subtitlesSkipped: (n: number, why: readonly string[]) =>
    `${n === 1 ? 'uma legenda foi pulada' : `${n} legendas foram puladas`}: ${why.join(' ')}`,
  textGuessed: (encoding: string) => `não está em UTF-8, por isso o seu texto foi lido como ${encoding}.`,
  textLost: (n: number) => (n === 1 ? '1 caractere não pôde ser lido.' : `${n} caracteres não puderam ser lidos.`),
  changeEncoding: 'Alterar codificação',
  encodingOf: (name: string) => `Codificação de ${name}`,
  encoding: 'Codificação',
  encodingPreview: 'Prévia',
  readAgain: 'Ler novamente',
  wordsWaiting: (n: number) => (n === 1 ? '1 texto não posicionado' : `${n} textos não posicionados`),
  wordsWaitingWhy:
    'Um texto volta quando uma página mostra de novo a sua foto. Um texto sem foto fica aqui até você colocá-lo em uma página.',
  putWaiting: (text: string) => `Pôr nesta página: ${text}`,
  dropWaiting: (text: string) => `Descartar: ${text}`,
  dropAllWaiting: 'Descartar todos',
};
