/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Estilo de uma imagem',
  styleFromPictureHelp:
    'Leva para suas fotos o visual de uma imagem: uma página de quadrinhos, uma gravura ou uma pintura',
  imitationAbout:
    'Escolha uma imagem cujo visual você quer: uma página de quadrinhos, uma gravura, um desenho, uma pintura. Em poucos segundos são procurados estilos que dão esse visual à sua própria foto. A imagem não sai deste aparelho.',
  imitationDrop: 'Você também pode soltar uma imagem em qualquer lugar com a tecla Alt pressionada.',
  imitationChoose: 'Escolher uma imagem',
  imitationOther: 'Outra imagem',
  imitationFile: 'Imagem cujo estilo é procurado',
  imitationAgain: 'Procurar de novo',
  imitationAnyway: 'Procurar mesmo assim',
  imitating: 'Procurando estilos…',
  imitationProposals: 'Estilos encontrados',
  imitationPhotos: 'Foto para experimentá-los',
  imitationNone: 'Nenhum estilo chegou perto desta imagem. Tente outra.',
  imitationNeedsPhotos: 'Escolha fotos primeiro: o estilo de uma imagem é experimentado em uma delas.',
  dropForStyle: 'Solte aqui, ou com Alt pressionada, para aproveitar o estilo de uma imagem',
  imitationFound: (n: number) =>
    n === 1
      ? '1 estilo encontrado. Ele é seu quando você o usa, edita ou salva.'
      : `${n} estilos encontrados. Um deles é seu quando você o usa, edita ou salva.`,
  imitationName: (picture: string, place: number) => `Como ${picture} ${place}`,
  imitationPictureOf: (name: string) => `A imagem ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Esta imagem é pequena demais para ler um estilo: cada lado precisa de 64 pixels.',
    'blank-picture': 'Esta imagem está em branco: não há estilo nela.',
    'plain-photo':
      'Parece uma foto comum: não há linhas, tintas ou pintura para aproveitar. Escolha um desenho, uma gravura ou uma pintura.',
    'imitation-missing': 'Não foi possível carregar o que encontra estilos em imagens. Tente de novo com conexão.',
    'worker-lost': 'A leitura desta imagem parou o programa. Tente outra.',
    'unreadable-file': 'O arquivo foi movido, alterado ou apagado desde que você o escolheu.',
    'unknown-format':
      'Não é uma imagem que possa ser lida. Escolha um arquivo JPEG, PNG, WebP, AVIF, GIF, BMP ou TIFF.',
    damaged: 'O arquivo desta imagem está danificado ou incompleto.',
    'too-large': 'Esta imagem é grande demais.',
  } as Record<string, string>,
};
