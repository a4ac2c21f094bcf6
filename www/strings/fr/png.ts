const photos = (n: number) => (n < 2 ? `${n} photo` : `${n} photos`);

export function some(names: readonly string[]) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} et ${rest} ${rest === 1 ? 'autre' : 'autres'}` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Dans le PNG',
  cargoKind: {
    project: 'Avec les données du projet',
    photos: 'Avec les photos',
    none: 'Sans données du projet',
  },
  cargoHelp: {
    project: 'Déposez le PNG ici pour le modifier de nouveau. Il retrouve ses photos sur cet appareil.',
    photos: 'Contient vos photos d’origine, et s’ouvre donc sur tout appareil. Quiconque a le fichier peut les voir.',
    none: 'Seulement l’image.',
  },
  cargoClean: 'Le lieu, la date et l’appareil de vos photos n’y sont jamais.',
  photosUnclean: (n: number) =>
    `${photos(n)} à l’intérieur ${n < 2 ? 'dit' : 'disent'} peut-être encore où et quand : Inkpanel ne peut pas l’ôter des fichiers de ce type.`,

  noProjectInside: 'c’est une image sans données de projet.',
  pageOpened: (name: string) => `${name} est de nouveau ouverte, comme projet à part.`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name} est ouverte, mais il manque ${n} photo${n < 2 ? '' : 's'} sur ${of} sur cet appareil. ${n === 1 ? 'Choisissez-la ou déposez-la' : 'Choisissez-les ou déposez-les'} ici : chacune retrouve sa place.`,
  photosBack: (n: number) => `${photos(n)} de retour à ${n < 2 ? 'sa' : 'leur'} place.`,
  photosStillMissing: (n: number) =>
    `Il manque encore ${photos(n)} de cette page. ${n === 1 ? 'Choisissez-la ou déposez-la' : 'Choisissez-les ou déposez-les'} ici : chacune retrouve sa place.`,
  absentPhoto: (n: number) => `Photo absente ${n}`,
  choosePhotos: 'Choisir des photos',
  openedAsPicture: (name: string) =>
    `${name} est maintenant une photo de ce projet. Les photos de cette page ne sont pas sur cet appareil.`,
  openAsProject: 'Ouvrir comme projet',
  useAsPhoto: 'Utiliser comme photo',
  backTo: (name: string) => `Revenir à ${name}`,

  removeMetadata: 'Supprimer le lieu et les données d’appareil',
  removeMetadataHelp:
    'Pour les fichiers que vous transmettez. Les dates sont aussi supprimées : un nouveau livre ne peut plus classer les photos par jour.',
  /** @param unclean: files that kept their metadata; null if no metadata was removed */
  projectSaved: (unclean: readonly string[] | null) =>
    unclean === null
      ? 'Le projet a été enregistré dans un fichier, avec vos photos d’origine. Leur lieu, leur date et leurs données d’appareil y figurent.'
      : unclean.length === 0
        ? 'Le projet a été enregistré dans un fichier, avec vos photos en taille réelle, mais sans leur lieu, leur date ni leur appareil.'
        : `Le projet a été enregistré dans un fichier, avec vos photos en taille réelle. ${some(unclean)} ${unclean.length === 1 ? 'dit' : 'disent'} peut-être encore où et quand : Inkpanel ne peut pas l’ôter des fichiers de ce type.`,
};
