export const offlineStrings = {
  newVersion: 'Há uma versão nova.',
  reload: 'Recarregar',
  notReloaded: 'A página não foi recarregada, porque seu trabalho não está salvo.',
  install: 'Instalar',
  installHelp: 'Abre o Inkpanel em uma janela própria, também sem conexão',
  sharedLost:
    'O que foi compartilhado não chegou: o armazenamento deste navegador pode estar cheio. Adicione as fotos aqui.',
  launchFailed: (name: string) => `Não foi possível abrir ${name}. Adicione aqui.`,
  noDetectorOffline:
    'Sem conexão ainda não dá para encontrar rostos, então as fotos são enquadradas pelo contraste até haver uma.',
};
