export const offlineStrings = {
  newVersion: 'Há uma versão nova.',
  reload: 'Recarregar',
  notReloaded: 'O aplicativo não foi recarregado, porque seu trabalho não está salvo.',
  install: 'Instalar',
  installHelp: 'Abre o Inkpanel em uma janela própria, também sem conexão',
  sharedLost:
    'Os arquivos compartilhados não chegaram. O armazenamento deste navegador pode estar cheio. Adicione as fotos aqui.',
  launchFailed: (name: string) => `Não foi possível abrir ${name}. Adicione aqui.`,
  noDetectorOffline:
    'A detecção de rostos precisa ser baixada uma vez. Até haver conexão, as fotos são enquadradas pelo contraste.',
};
