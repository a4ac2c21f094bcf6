const photos = (n: number) => (n < 2 ? `${n} foto` : `${n} fotos`);

export function some(names: readonly string[]) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} e mais ${rest}` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Dentro do PNG',
  cargoKind: { project: 'Com dados do projeto', photos: 'Com as fotos', none: 'Sem dados do projeto' },
  cargoHelp: {
    project: 'Solte o PNG aqui para editá-lo de novo. Ele acha suas fotos neste aparelho.',
    photos:
      'Inclui suas fotos originais e por isso abre em qualquer aparelho. Qualquer pessoa com o arquivo pode vê-las.',
    none: 'Só a imagem.',
  },
  cargoClean: 'O lugar, a data e a câmera das suas fotos nunca vão dentro.',
  photosUnclean: (n: number) =>
    `${photos(n)} dentro dele talvez ainda ${n < 2 ? 'diga' : 'digam'} onde e quando: o Inkpanel não consegue tirar isso de arquivos desse tipo.`,

  noProjectInside: 'é uma imagem sem dados de projeto.',
  pageOpened: (name: string) => `${name} está aberta de novo, como um projeto próprio.`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name} está aberta, mas neste aparelho ${n === 1 ? 'falta' : 'faltam'} ${n} de ${photos(of)}. ${n === 1 ? 'Escolha-a ou solte-a' : 'Escolha-as ou solte-as'} aqui: cada uma volta ao seu lugar.`,
  photosBack: (n: number) => `${photos(n)} de volta ao lugar.`,
  photosStillMissing: (n: number) =>
    `Ainda ${n === 1 ? 'falta' : 'faltam'} ${photos(n)} desta página. ${n === 1 ? 'Escolha-a ou solte-a' : 'Escolha-as ou solte-as'} aqui: cada uma volta ao seu lugar.`,
  absentPhoto: (n: number) => `Foto faltando ${n}`,
  choosePhotos: 'Escolher fotos',
  openedAsPicture: (name: string) =>
    `${name} agora é uma foto deste projeto. As fotos daquela página não estão neste aparelho.`,
  openAsProject: 'Abrir como projeto',
  useAsPhoto: 'Usar como foto',
  backTo: (name: string) => `Voltar a ${name}`,

  removeMetadata: 'Remover localização e dados da câmera',
  removeMetadataHelp:
    'Para arquivos que você passa adiante. As datas também são removidas, e um livro novo não pode ordenar as fotos por dia.',
  /** @param unclean: files that kept their metadata; null if no metadata was removed */
  projectSaved: (unclean: readonly string[] | null) =>
    unclean === null
      ? 'O projeto foi salvo como arquivo, com suas fotos originais. Ele inclui o lugar, a data e os dados da câmera.'
      : unclean.length === 0
        ? 'O projeto foi salvo como arquivo, com suas fotos em tamanho total, mas sem lugar, data nem câmera.'
        : `O projeto foi salvo como arquivo, com suas fotos em tamanho total. ${some(unclean)} talvez ainda ${unclean.length === 1 ? 'diga' : 'digam'} onde e quando: o Inkpanel não consegue tirar isso de arquivos desse tipo.`,
};
