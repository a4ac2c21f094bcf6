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
};
