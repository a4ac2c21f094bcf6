import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'o armazenamento deste navegador está cheio',
  refused: 'este navegador bloqueia aqui o armazenamento de sites',
};

export const storageStrings = {
  // Saving
  saveState: {
    empty: '',
    saving: 'Salvando…',
    saved: 'Salvo',
    missing: 'Salvo em parte',
    full: 'Não salvo',
    refused: 'Não salvo',
    failed: 'Não salvo',
  },
  savingCount: (done: number, total: number) => `Salvando ${done} de ${total}`,
  saveHelp: 'Seu trabalho é salvo neste navegador, neste aparelho',
  notSaved: (why: string, message: string) =>
    `Seu trabalho não está salvo: ${TROUBLE[why] ?? message.replace(/\.$/, '')}. Ele será perdido se você fechar esta aba.`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)}: não salvo, ${names.length === 1 ? 'o arquivo não pode mais ser lido' : 'os arquivos não podem mais ser lidos'}. Todo o resto está salvo.`,
  photosNotHere: (names: readonly string[], of: number) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} de ${of} fotos` : one ? 'A foto' : `Todas as ${of} fotos`;
    return `${which} não ${one ? 'está' : 'estão'} neste navegador: ${some(names)}. ${one ? 'Escolha-a ou solte-a' : 'Escolha-as ou solte-as'} aqui: cada uma volta ao seu lugar.`;
  },
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)}: não ${names.length === 1 ? 'está' : 'estão'} mais neste navegador, mas as imagens tiradas estão. Para tirar outras, adicione o vídeo de novo.`,
  photosNeverSaved: (names: readonly string[]) =>
    `O aplicativo foi fechado antes de salvar ${some(names)}. ${names.length === 1 ? 'Escolha-a' : 'Escolha-as'} de novo.`,
  saveAgain: 'Salvar de novo',
  goOnWithout: 'Continuar sem isso',
  saveToFile: 'Salvar em um arquivo',
  conflict: 'Outra aba alterou este projeto. Esta aba continua com uma cópia.',

  // Projects
  projects: 'Projetos',
  projectName: 'Nome do projeto',
  untitled: 'Sem título',
  newProject: 'Novo projeto',
  openProject: 'Abrir arquivo de projeto',
  saveProject: 'Salvar arquivo de projeto',
  projectFile: 'Arquivo de projeto',
  openNamed: (name: string) => `Abrir ${name}`,
  duplicateNamed: (name: string) => `Duplicar ${name}`,
  deleteNamed: (name: string) => `Excluir ${name}`,
  renameNamed: (name: string) => `Renomear ${name}`,
  newNameOf: (name: string) => `Novo nome de ${name}`,
  sampleAlbum: 'Álbum de exemplo',
  openNow: 'Aberto agora',
  projectAbout: (photos: number, when: string) =>
    `${photos < 2 ? `${photos} foto` : `${photos} fotos`}${when && `, ${when}`}`,
  noProjects: 'Seu trabalho é salvo aqui automaticamente.',
  projectDeleted: (name: string) => `${name} foi excluído.`,
  bringBack: 'Restaurar',
  projectNotOpened: (why: string) => `Não foi possível abrir o projeto: ${why}`,
  projectFileNotOpened: (name: string, why: string) => `Não foi possível abrir ${name}: ${why}`,
  projectNotSaved: (why: string) => `Não foi possível salvar o projeto como arquivo: ${why}`,
  projectReasons: {
    'damaged-project': 'está danificado ou não é um projeto do Inkpanel. Sua página não mudou.',
    'too-large-project': 'ultrapassa os limites de um projeto. Sua página não mudou.',
    'silent-project': 'a leitura do arquivo foi interrompida depois de um minuto. Verifique o disco e tente de novo.',
    'newer-project': 'foi salvo com uma versão mais nova do Inkpanel. Recarregue esta aba para atualizar.',
    'not-saved': 'seu trabalho não está salvo. Salve antes em um arquivo (Salvar arquivo de projeto).',
    'missing-project': 'foi excluído.',
    'no-storage': 'este navegador bloqueia aqui o armazenamento de sites.',
    'too-large': 'o arquivo passaria de 4 GB.',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `${others.length + 1} projetos foram abertos, cada um por si. ${shown} está na página; ${others.length === 1 ? `${others[0]} está` : `outros ${others.length} estão`} em Projetos.`,
  photosWithProject: (n: number, name: string) =>
    n === 1
      ? `A foto que veio junto foi adicionada a ${name}.`
      : `As ${n} fotos que vieram junto foram adicionadas a ${name}.`,
  projectBroken: (name: string, why: string) => `${name} não pode ser mostrado: ${why}.`,
  brokenReasons: {
    'damaged-project': 'uma parte está danificada',
    'too-large-project': 'ultrapassa os limites de um projeto',
    'newer-project': 'foi salvo com uma versão mais nova do Inkpanel. Recarregue esta aba para atualizar',
  } as Record<string, string>,
  brokenOtherwise: 'uma parte não pode ser desenhada',
  brokenKept: 'O projeto e suas fotos não mudaram.',
  partsLeftOut: (name: string, n: number) =>
    `${name} está aberto sem ${n === 1 ? 'uma parte que não pôde ser lida' : `${n} partes que não puderam ser lidas`}.`,
  openAnother: 'Abrir outro',
  saveAsFile: 'Salvar como arquivo',
  goBack: 'Restaurar a última versão boa',
  noGoodState: 'Não há versão anterior para restaurar.',
  wentBack: (name: string) => `A última versão boa de ${name} foi restaurada.`,
  openingProject: (name: string) => `Abrindo ${name}`,
  openingLast: 'Abrindo seu projeto',
  openElsewhere: (name: string) => `${name} está aberto em outra aba.`,
  opensWhenFree: 'Ele abre aqui quando você fechar a outra aba.',
  openCopy: 'Abrir uma cópia',

  // Pages shown
  pagesShown: 'Histórico da página',
  pagesShownAt: (n: number, of: number) => `Histórico da página, ${n}/${of}`,
  pageNumber: (n: number) => `Página ${n}`,
  versionFrom: (n: number) => `da versão ${n}`,
  favouritePage: 'Página favorita',
  favouritePages: 'Só favoritas',
  versionNumber: (n: number) => `Versão ${n}`,
  compareShort: 'Comparar',
  comparePage: (n: number) => `Comparar versão ${n}`,
  comparedAll: 'Mostrar todas as versões',
  compareSecond: 'Escolha a segunda versão para comparar',
  noFavouritePages: 'Nenhuma favorita ainda. Aperte o coração de uma página de que você goste.',
};
