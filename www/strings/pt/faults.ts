export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}: ${why}`,
  filesFailed: (n: number) => `Não foi possível ler ${n} arquivos.`,
  internalError: (what: string) => `ocorreu um erro interno: ${what}`,
  showList: 'Ver a lista',
  moreFiles: (n: number) => `e mais ${n}`,
  /** The core's own sentences are English, so all its codes are here. */
  reasons: {
    'animatic-encoder': 'o navegador parou de codificá-la. Escolha um tamanho menor ou outro tipo de arquivo.',
    'animatic-long': 'um arquivo GIF dura no máximo um minuto. Escolha MP4 ou WebM, ou planos mais curtos.',
    'animatic-sound': 'este navegador não codifica som para esse arquivo. Escolha WebM ou retire o som.',
    'sound-unread': 'o navegador não consegue ler o som. Converta para MP3 ou WAV.',
    'film-cut': 'o arquivo está incompleto (falta o índice). Copie-o de novo da origem.',
    'film-empty': 'o vídeo não tem imagens.',
    'films-missing': 'não foi possível carregar o leitor de vídeo. Verifique a conexão e tente de novo.',
    'texts-missing': 'não foi possível carregar o leitor de arquivos de texto. Verifique a conexão e tente de novo.',
    'worker-lost': 'o Inkpanel falhou duas vezes ao lê-lo, por isso ele foi pulado.',
    'unreadable-file': 'o arquivo foi movido, alterado ou apagado depois que você o escolheu.',
    'not-text': 'não é um arquivo de texto, ou a codificação é desconhecida. Salve-o como UTF-8.',
    'unreadable-entry': 'o navegador não consegue lê-lo. Talvez esteja só na nuvem ou seja um link quebrado.',
    'unreadable-folder': 'o navegador não consegue ler todos os arquivos desta pasta.',
    'unknown-format': 'não é uma imagem que o Inkpanel saiba ler (JPEG, PNG, WebP, GIF, BMP ou TIFF).',
    damaged: 'o arquivo está danificado ou incompleto.',
    unsupported: 'este tipo de arquivo não pode ser lido.',
    'too-large': 'é grande demais.',
    'no-decoder':
      'este navegador não sabe ler este tipo de foto. Salve-a como JPEG ou abra esta página em outro navegador.',
    'no-room': 'o navegador não tem espaço para a foto.',
    'missing-photo': 'a foto não está carregada.',
    'no-photos': 'não há nenhuma foto que possa ser usada.',
    encode: 'não foi possível codificar a página.',
    'video-codec': 'este navegador não sabe decodificar o vídeo.',
    'video-decoder': 'este navegador não sabe decodificar o vídeo.',
    'video-format': 'não é um vídeo MP4, MOV, WebM ou Matroska completo.',
    'video-empty': 'não tem imagem, só som.',
    'video-memory': 'não há memória suficiente para um quadro do vídeo.',
    'video-worker': 'o leitor do vídeo parou.',
    'words-missing': 'não foi possível carregar as letras.',
    'files-missing': 'não foi possível carregar o que cria este tipo de arquivo. Tente de novo ou salve um PNG.',
    'decoders-missing': 'não foi possível carregar o que lê estas fotos. Tente de novo com conexão.',
    'painters-missing': 'não foi possível carregar os pintores. Tente de novo com conexão.',
    'core-missing': 'não foi possível carregar o programa.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n === 1 ? '1 arquivo ficou' : `${n} arquivos ficaram`} de fora: um projeto aceita ${most} fotos.`,
  /** Reasons by error code that name the kind of file. */
  reasonsOf: {
    'film-container': (what: string) =>
      `o Inkpanel não consegue ler este formato de vídeo (${what}). Converta-o para MP4 com vídeo H.264, por exemplo com HandBrake ou ffmpeg.`,
    'film-codec': (what: string) =>
      `este navegador não consegue decodificar vídeo ${what}. Converta-o para MP4 com vídeo H.264, por exemplo com HandBrake ou ffmpeg.`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) =>
    `${name}: ${share} da imagem estão danificados e são desenhados em cinza.`,
  photoCoarse: (name: string, share: string) =>
    `${name}: ${share} da imagem estão sem detalhes, porque o arquivo está danificado ou incompleto.`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name} está incompleto: termina em ${till} de ${whole}. Todas as imagens são dessa parte.`,
  noUsablePhoto:
    'Nenhum destes arquivos pôde ser usado. Escolha fotos JPEG, PNG, WebP, AVIF, GIF, BMP ou TIFF, ou um vídeo.',
  noSamples: 'Não foi possível carregar o álbum de exemplo. Verifique a conexão e tente de novo.',
  noPhotosInUse: 'Nenhuma foto está em uso. Marque uma em Fotos para ter uma página.',
  panelFailed: (why: string) => `Não foi possível desenhar um quadro: ${why}`,
  partMissing: 'Não foi possível carregar esta parte do Inkpanel. Verifique a conexão e tente de novo.',
  notDone: (why: string) => `Não foi possível fazer isso: ${why}`,
  coreFailed: (why: string) => `O Inkpanel não conseguiu iniciar: ${why}`,
  locked: { layout: 'O layout está travado.', style: 'O estilo está travado.', photos: 'As fotos estão travadas.' },
};
