/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Estilo de uma imagem',
  styleFromPictureHelp: 'Aplica às suas fotos o visual de uma página de quadrinhos, uma gravura ou uma pintura',
  imitationAbout:
    'Escolha uma imagem com o visual que você quer: uma página de quadrinhos, uma gravura, um desenho ou uma pintura. Em poucos segundos, o Inkpanel encontra estilos que dão esse visual à sua foto. A imagem não sai deste aparelho.',
  imitationDropHere: 'Ou solte uma imagem aqui.',
  imitationChoose: 'Escolher uma imagem',
  imitationOther: 'Outra imagem',
  imitationFile: 'Imagem com o estilo que você quer',
  imitationAgain: 'Procurar de novo',
  imitationAnyway: 'Procurar mesmo assim',
  imitating: 'Procurando estilos…',
  imitationProposals: 'Estilos encontrados',
  imitationPhotos: 'Foto para a prévia',
  imitationNone: 'Nenhum estilo chegou perto desta imagem. Tente outra.',
  imitationNeedsPhotos: 'Escolha fotos primeiro: o Inkpanel mostra os estilos em uma delas.',
  dropForStyle: 'Solte aqui, ou com Alt pressionada, para aproveitar o estilo de uma imagem',
  imitationFound: (n: number) =>
    n === 1
      ? '1 estilo encontrado. Use, edite ou salve para mantê-lo.'
      : `${n} estilos encontrados. Use, edite ou salve um para mantê-lo.`,
  imitationName: (picture: string, place: number) => `Como ${picture} ${place}`,
  imitationPictureOf: (name: string) => `A imagem ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Esta imagem é pequena demais. Cada lado precisa de pelo menos 64 pixels.',
    'blank-picture': 'Esta imagem está em branco, por isso não tem estilo.',
    'plain-photo':
      'Parece uma foto comum sem linhas, tintas ou pintura. Escolha um desenho, uma gravura ou uma pintura.',
    'imitation-missing': 'Não foi possível carregar a busca de estilos. Verifique a conexão e tente de novo.',
    'worker-lost': 'O Inkpanel falhou ao ler esta imagem. Tente outra.',
    'unreadable-file': 'O arquivo foi movido, alterado ou apagado desde que você o escolheu.',
    'unknown-format':
      'Não é uma imagem que possa ser lida. Escolha um arquivo JPEG, PNG, WebP, AVIF, GIF, BMP ou TIFF.',
    damaged: 'O arquivo desta imagem está danificado ou incompleto.',
    'too-large': 'Esta imagem é grande demais.',
  } as Record<string, string>,
};
