/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Style d’après une image',
  styleFromPictureHelp: 'Donne à vos photos l’aspect d’une image : une planche de BD, une estampe, une peinture',
  imitationAbout:
    'Choisissez une image dont l’aspect vous plaît : une planche de BD, une estampe, un dessin, une peinture. En quelques secondes, des styles qui donnent cet aspect à votre propre photo sont cherchés. L’image reste sur cet appareil.',
  imitationDrop: 'Vous pouvez aussi déposer une image n’importe où en maintenant Alt.',
  imitationChoose: 'Choisir une image',
  imitationOther: 'Une autre image',
  imitationFile: 'Image dont le style est cherché',
  imitationAgain: 'Chercher encore',
  imitationAnyway: 'Chercher quand même',
  imitating: 'Recherche de styles…',
  imitationProposals: 'Styles trouvés',
  imitationPhotos: 'Photo pour les essayer',
  imitationNone: 'Aucun style n’approche cette image. Essayez-en une autre.',
  imitationNeedsPhotos: 'Choisissez d’abord des photos : le style d’une image s’essaie sur l’une d’elles.',
  dropForStyle: 'Relâchez ici, ou en maintenant Alt, pour reprendre le style d’une image',
  imitationFound: (n: number) =>
    n === 1
      ? '1 style trouvé. Il est à vous quand vous l’utilisez, le modifiez ou l’enregistrez.'
      : `${n} styles trouvés. L’un d’eux est à vous quand vous l’utilisez, le modifiez ou l’enregistrez.`,
  imitationName: (picture: string, place: number) => `Comme ${picture} ${place}`,
  imitationPictureOf: (name: string) => `L’image ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Cette image est trop petite pour y lire un style : chaque côté doit avoir 64 pixels.',
    'blank-picture': 'Cette image est vide : elle ne contient aucun style.',
    'plain-photo':
      'Cela ressemble à une simple photo : il n’y a ni traits, ni encres, ni peinture à reprendre. Choisissez un dessin, une estampe ou une peinture.',
    'imitation-missing':
      'Ce qui trouve des styles dans les images n’a pas pu être chargé. Réessayez avec une connexion.',
    'worker-lost': 'La lecture de cette image a arrêté le programme. Essayez-en une autre.',
    'unreadable-file': 'Le fichier a été déplacé, modifié ou supprimé depuis que vous l’avez choisi.',
    'unknown-format': 'Ce n’est pas une image lisible. Choisissez un fichier JPEG, PNG, WebP, AVIF, GIF, BMP ou TIFF.',
    damaged: 'Le fichier de cette image est endommagé ou tronqué.',
    'too-large': 'Cette image est trop grande.',
  } as Record<string, string>,
};
