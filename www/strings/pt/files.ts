/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'Dentro do arquivo',
  cargoFileHelp: {
    project: 'Solte o arquivo aqui para editá-lo de novo. Ele acha suas fotos neste aparelho.',
    photos:
      'Inclui suas fotos originais e por isso abre em qualquer aparelho. Qualquer pessoa com o arquivo pode vê-las.',
    none: 'Só as páginas.',
  },
  packingPhotos: (percent: string) => `Adicionando as fotos, ${percent}`,
  photosTooLarge: 'juntas, as fotos são grandes demais para um PNG. Salve o projeto como arquivo.',
  savingProject: (done: number, total: number) => `Salvando o projeto, ${Math.floor(done)} de ${total} arquivos`,
  damagedInArchive: (archive: string) => `está danificada em ${archive}.`,
  noPicturesInside: 'não há nenhuma imagem dentro.',
  unknownJson: 'não é um layout nem um estilo do Inkpanel.',
  filesSkipped: (n: number) =>
    n === 1
      ? '1 arquivo que um sistema ou programa guarda ao lado das fotos foi ignorado.'
      : `${n} arquivos que sistemas e programas guardam ao lado das fotos foram ignorados.`,
  /** `remedy`: a request to the user */
  unsupportedKind: (name: string, remedy: string) => `este tipo de arquivo (${name}) não pode ser lido. ${remedy}`,
  remedies: {
    jpeg: 'Salve-o como JPEG em um programa que o abra.',
    unpack: 'Descompacte-o e adicione suas imagens, ou compacte-as como ZIP.',
    pages: 'Salve suas páginas como PNG ou JPEG.',
    mp4: 'Converta-o para MP4 com vídeo H.264.',
    srt: 'Converta-o para SRT ou WebVTT.',
    fountain: 'Exporte-o como Fountain.',
    csv: 'Salve-o como CSV.',
    text: 'Salve-o como texto simples.',
  },
  boardFile: 'é um roteiro ou uma tabela. Abra o storyboard e escolha “Importar roteiro ou tabela”.',
  liveVideos: (n: number) =>
    n === 1
      ? '1 vídeo de uma Live Photo não foi adicionado, só a foto.'
      : `${n} vídeos de Live Photos não foram adicionados, só as fotos.`,
  addLiveVideos: (n: number): string => (n === 1 ? 'Adicionar o vídeo' : 'Adicionar os vídeos'),
};
