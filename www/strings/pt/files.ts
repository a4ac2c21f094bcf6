/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'Dentro do arquivo',
  cargoFileHelp: {
    project: 'Solte o arquivo aqui para continuar o trabalho. Ele encontra as fotos neste dispositivo.',
    photos: 'Abre em qualquer dispositivo, com as fotos. Quem tem o arquivo tem as fotos.',
    none: 'As páginas e nada mais.',
  },
  packingPhotos: (percent: string) => `Adicionando as fotos, ${percent}`,
  photosTooLarge: 'juntas, as fotos são grandes demais para um PNG. Salve o projeto como arquivo.',
  savingProject: (done: number, total: number) => `Salvando o projeto, ${Math.floor(done)} de ${total} arquivos`,
  damagedInArchive: (archive: string) => `está danificada em ${archive}.`,
  noPicturesInside: 'não há nenhuma imagem dentro.',
  unknownJson: 'não é um layout nem um estilo do Inkpanel.',
};
