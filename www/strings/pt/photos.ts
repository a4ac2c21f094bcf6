export const photoStrings = {
  photos: 'Fotos',
  usePhoto: (name: string) => `Usar ${name}`,
  pickPhoto: (name: string) => `Escolher ${name}`,
  pickLong: 'Clique para pôr no quadro selecionado ou no próximo em que clicar; ou arraste para um quadro',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `no quadro ${panel}` : `na página ${page}, quadro ${panel}`,
  youLeftOut: 'Você excluiu',
  leftOut: (name: string) => `${name} foi excluída.`,
  starPhoto: (name: string) => `Destacar ${name}`,
  starLong: 'Aumenta o quadro desta foto e a mostra grande em cada embaralhada',
  starLocked: 'Foto destacada. O layout ou o quadro está bloqueado, por isso o quadro mantém o tamanho.',
  starKeepsSize: 'Foto destacada. Este layout não tem espaço para um quadro maior; Embaralhar mostra a foto grande.',
  removePhoto: (name: string) => `Remover ${name}`,
  photoMissing: 'Faltando',
  addPhotos: 'Adicionar fotos',
  kept: 'Em uso',
  unseen: {
    waits: 'Ainda não apareceu',
    text: 'Não aparece: parece uma página de texto',
    small: 'Não aparece: tem poucos pixels',
  },
  setAside: 'Excluídas',
  setAsideWhy: 'Parecidas e desfocadas. Marque uma para usá-la.',
  choice: 'Escolha das fotos',
  alike: 'Excluir as parecidas',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, quase idênticas`
      : bits < 11
        ? `${bits}, a mesma imagem`
        : bits < 14
          ? `${bits}, muito parecidas`
          : `${bits}, um pouco parecidas`,
  alikeKept: (kept: number, all: number) => `${kept} de ${all} em uso`,
  order: 'Ordem',
  orders: { time: 'Data da foto', name: 'Nome do arquivo' },
  stackWhy: 'Elas se parecem. A marcada é usada; marque mais ou use outra.',
  stackOf: (count: number) => `${count} parecidas`,
  openStack: (count: number, name: string) => `Mostrar as ${count} fotos parecidas com ${name}`,
  take: 'Usar',
  takeInstead: (name: string) => `Usar ${name} no lugar`,
  credit: ({ title, author, licence }: { title: string; author: string; licence: string }) =>
    `${title}, de ${author} (${licence})`,
  photoCount: (used: number, all: number) => (used === all ? `${all}` : `${used} de ${all}`),
  reading: (done: number, total: number) => `Lendo fotos, ${done} de ${total}`,
  cancelReading: 'Parar de ler',

  // Videos
  videos: 'Vídeos',
  videoFrames: (count: number) => (count < 2 ? `${count} imagem` : `${count} imagens`),
  trimStart: 'Início',
  trimEnd: 'Fim',
  frames: 'Imagens do vídeo',
  lookingThrough: (name: string, percent: string) => `Analisando ${name}, ${percent}`,
  takeFrames: 'Usar estas imagens',

  showSubjects: 'Mostrar o que foi encontrado',
  finding: (done: number, total: number) => `Detectando rostos e objetos: ${done} de ${total} fotos`,
  masking: (done: number, total: number) => `Detectando assuntos: ${done} de ${total} fotos`,
  stopMasking: 'Parar a detecção de assuntos',
  goOnMasking: 'Retomar a detecção de assuntos',
  noDetector: 'A detecção de rostos não está disponível aqui, então as fotos são enquadradas pelo contraste.',
};
