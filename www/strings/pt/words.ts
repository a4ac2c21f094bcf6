type Kind = 'caption' | 'balloon' | 'effect';

export const wordStrings = {
  words: 'Texto',
  addWord: { caption: 'Adicionar caixa de texto', balloon: 'Adicionar balão', effect: 'Adicionar onomatopeia' },
  wordShort: { caption: 'Caixa', balloon: 'Balão', effect: 'Som' },
  /** What a new word says. */
  wordSample: { caption: 'Enquanto isso…', balloon: 'Oi!', effect: 'BUM!' },
  wordKind: { caption: 'Caixa de texto', balloon: 'Balão', effect: 'Onomatopeia' },
  word: (kind: Kind, text: string) => `${wordStrings.wordKind[kind]}: ${text}`,
  wordKeys: 'Enter edita o texto, as setas o movem, Delete o remove',
  wordText: (name: string) => `Texto de ${name}`,
  wordTail: (name: string) => `Rabicho de ${name}`,
  tailKeys: 'As setas movem a ponta do rabicho',
  wordList: 'Textos da página',
  noWords: 'Nenhum texto ainda.',
  shape: 'Forma',
  shapes: { oval: 'Fala', thought: 'Pensamento', shout: 'Grito', whisper: 'Sussurro', radio: 'Rádio' },
  editWord: 'Editar texto',
  moveWord: 'Mover para…',
  pointTail: 'Apontar rabicho para…',
  removeTail: 'Remover rabicho',
  placeWord: 'Posição automática',
  removeWord: 'Remover texto',
  wordX: 'X',
  wordY: 'Y',
  wordWidth: 'Largura',
  wordSize: 'Tamanho',
  wordAuto: 'automático',
  wordAngle: 'Ângulo',
  wordArc: 'Arco',
  wordColor: 'Cor',
  wordFill: 'Fundo',
  wordFont: 'Fonte',
  fonts: { 'comic-neue': 'Comic Neue', 'comic-neue-bold': 'Comic Neue negrito', bangers: 'Bangers' },
  wordCut: 'O texto não coube e foi cortado.',
  wordModes: { move: 'Clique aonde ele vai', tail: 'Clique no que ele aponta' },
  wordRemoved: (name: string) => `${name}: removido.`,
  wordsFull: (most: number) => `Uma página pode ter no máximo ${most} textos. Remova alguns antes de adicionar mais.`,
  wordsFailed: (why: string) => `Não foi possível desenhar os textos: ${why}`,

  // Subtitles
  addSubtitles: 'Adicionar legendas',
  subtitlesFile: 'Arquivo de legendas',
  subtitlesAs: 'Como',
  subtitlesKinds: { caption: 'Caixas de texto', balloon: 'Balões' },
  subtitlesNoFrames: 'ainda não há página. Adicione primeiro fotos ou o vídeo.',
  subtitlesNoMatch: 'nenhuma legenda está perto do momento de uma imagem.',
  subtitlesLeft: (n: number, of: number) =>
    `${of} legendas foram lidas; mais ${n} ${n < 2 ? 'era demais e ficou' : 'eram demais e ficaram'} de fora.`,
  subtitlesCut: (n: number) =>
    n < 2
      ? 'uma legenda é longa demais, então o final dela ficou de fora.'
      : `${n} legendas são longas demais, então o final delas ficou de fora.`,
  subtitleErrors: {
    empty: 'não há legendas nele.',
    binary: 'não é um texto que se possa ler.',
    large: 'passa de 5 MB.',
    time: (line: number, text: string) => `linha ${line}: “${text}” não é um tempo como 00:01:02,500 --> 00:01:04,000.`,
    order: (line: number) => `linha ${line}: a legenda termina antes de começar.`,
    header: 'não começa com WEBVTT.',
    stray: (line: number, text: string) => `linha ${line}: era esperado um tempo, não “${text}”.`,
  },
};
