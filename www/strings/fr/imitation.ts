/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Style d’après une image',
  styleFromPictureHelp: 'Donne à vos photos l’aspect d’une planche de BD, d’une estampe ou d’une peinture',
  imitationAbout:
    'Choisissez une image avec l’aspect voulu : une planche de BD, une estampe, un dessin ou une peinture. En quelques secondes, Inkpanel trouve des styles qui donnent cet aspect à votre photo. L’image reste sur cet appareil.',
  imitationDropHere: 'Ou déposez une image ici.',
  imitationChoose: 'Choisir une image',
  imitationOther: 'Une autre image',
  imitationFile: 'Image avec le style voulu',
  imitationAgain: 'Chercher encore',
  imitationAnyway: 'Chercher quand même',
  imitating: 'Recherche de styles…',
  imitationProposals: 'Styles trouvés',
  imitationPhotos: 'Photo pour l’aperçu',
  imitationNone: 'Aucun style n’est proche de cette image. Essayez-en une autre.',
  imitationNeedsPhotos: 'Choisissez d’abord des photos : Inkpanel montre les styles sur l’une d’elles.',
  dropForStyle: 'Relâchez ici, ou en maintenant Alt, pour reprendre le style d’une image',
  imitationFound: (n: number) =>
    n === 1
      ? '1 style trouvé. Utilisez-le, modifiez-le ou enregistrez-le pour le garder.'
      : `${n} styles trouvés. Utilisez-en un, modifiez-le ou enregistrez-le pour le garder.`,
  imitationName: (picture: string, place: number) => `Comme ${picture} ${place}`,
  imitationPictureOf: (name: string) => `L’image ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Cette image est trop petite. Chaque côté doit avoir au moins 64 pixels.',
    'blank-picture': 'Cette image est vide et n’a donc pas de style.',
    'plain-photo':
      'Cela ressemble à une simple photo sans traits, encres ni peinture. Choisissez un dessin, une estampe ou une peinture.',
    'imitation-missing': 'La recherche de styles n’a pas pu être chargée. Vérifiez la connexion et réessayez.',
    'worker-lost': 'Inkpanel a planté en lisant cette image. Essayez-en une autre.',
    'unreadable-file': 'Le fichier a été déplacé, modifié ou supprimé depuis que vous l’avez choisi.',
    'unknown-format': 'Ce n’est pas une image lisible. Choisissez un fichier JPEG, PNG, WebP, AVIF, GIF, BMP ou TIFF.',
    damaged: 'Le fichier de cette image est endommagé ou tronqué.',
    'too-large': 'Cette image est trop grande.',
  } as Record<string, string>,
};
