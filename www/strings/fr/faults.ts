export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name} : ${why}`,
  filesFailed: (n: number) => `${n} fichiers n’ont pas pu être lus.`,
  internalError: (what: string) => `une erreur interne s’est produite : ${what}`,
  showList: 'Voir la liste',
  moreFiles: (n: number) => (n < 2 ? `et ${n} autre` : `et ${n} autres`),
  /** The core's own sentences are English, so all its codes are here. */
  reasons: {
    'animatic-encoder':
      'le navigateur a arrêté de l’encoder. Choisissez une taille plus petite ou un autre type de fichier.',
    'animatic-long': 'un fichier GIF dure une minute au plus. Choisissez MP4 ou WebM, ou des plans plus courts.',
    'animatic-sound': 'ce navigateur n’encode pas de son pour ce fichier. Choisissez WebM, ou retirez le son.',
    'sound-unread': 'le navigateur ne peut pas lire le son. Convertissez-le en MP3 ou WAV.',
    'film-cut': 'le fichier est incomplet (son index manque). Copiez-le de nouveau depuis la source.',
    'film-empty': 'la vidéo n’a aucune image.',
    'films-missing': 'le lecteur de vidéos n’a pas pu être chargé. Vérifiez la connexion et réessayez.',
    'texts-missing': 'le lecteur de fichiers texte n’a pas pu être chargé. Vérifiez la connexion et réessayez.',
    'worker-lost': 'Inkpanel a planté deux fois en le lisant, il a donc été ignoré.',
    'unreadable-file': 'le fichier a été déplacé, modifié ou supprimé depuis que vous l’avez choisi.',
    'not-text': 'ce n’est pas un fichier texte, ou son encodage est inconnu. Enregistrez-le en UTF-8.',
    'unreadable-entry': 'le navigateur ne peut pas le lire. Il n’est peut-être qu’en ligne, ou le lien est rompu.',
    'unreadable-folder': 'le navigateur ne peut pas lire tous les fichiers de ce dossier.',
    'unknown-format': 'ce n’est pas une image qu’Inkpanel sait lire (JPEG, PNG, WebP, GIF, BMP ou TIFF).',
    damaged: 'le fichier est abîmé ou incomplet.',
    unsupported: 'ce type de fichier ne peut pas être lu.',
    'too-large': 'il est trop grand.',
    'no-decoder':
      'ce navigateur ne sait pas lire ce type de photo. Enregistrez-la en JPEG ou ouvrez cette page dans un autre navigateur.',
    'no-room': 'le navigateur n’a pas de place pour la photo.',
    'missing-photo': 'la photo n’est pas chargée.',
    'no-photos': 'il n’y a aucune photo utilisable.',
    encode: 'la page n’a pas pu être encodée.',
    'video-codec': 'ce navigateur ne sait pas décoder la vidéo.',
    'video-decoder': 'ce navigateur ne sait pas décoder la vidéo.',
    'video-format': 'ce n’est pas une vidéo MP4, MOV, WebM ou Matroska complète.',
    'video-empty': 'elle n’a pas d’image, seulement du son.',
    'video-memory': 'il n’y a pas assez de mémoire pour une image.',
    'video-worker': 'le lecteur de la vidéo s’est arrêté.',
    'words-missing': 'les lettres n’ont pas pu être chargées.',
    'files-missing': 'ce qui crée ce genre de fichier n’a pas pu être chargé. Réessayez, ou enregistrez un PNG.',
    'decoders-missing': 'ce qui lit ces photos n’a pas pu être chargé. Réessayez avec une connexion.',
    'painters-missing': 'les peintres n’ont pas pu être chargés. Réessayez avec une connexion.',
    'core-missing': 'le programme n’a pas pu être chargé.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n === 1 ? '1 fichier a été laissé' : `${n} fichiers ont été laissés`} de côté : un projet contient ${most} photos.`,
  /** Reasons by error code that name the kind of file. */
  reasonsOf: {
    'film-container': (what: string) =>
      `Inkpanel ne peut pas lire ce format vidéo (${what}). Convertissez-le en MP4 avec une vidéo H.264, avec HandBrake ou ffmpeg par exemple.`,
    'film-codec': (what: string) =>
      `ce navigateur ne peut pas décoder la vidéo ${what}. Convertissez-la en MP4 avec une vidéo H.264, avec HandBrake ou ffmpeg par exemple.`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) => `${name} : ${share} de l’image sont endommagés et dessinés en gris.`,
  photoCoarse: (name: string, share: string) =>
    `${name} : ${share} de l’image manquent de détails, car le fichier est endommagé ou incomplet.`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name} est incomplète : elle s’arrête à ${till} sur ${whole}. Toutes les images viennent de cette partie.`,
  noUsablePhoto:
    'Aucun de ces fichiers n’a pu servir. Choisissez des photos JPEG, PNG, WebP, AVIF, GIF, BMP ou TIFF, ou une vidéo.',
  noSamples: 'L’album d’exemple n’a pas pu être chargé. Vérifiez la connexion et réessayez.',
  noPhotosInUse: 'Aucune photo n’est utilisée. Cochez-en une dans Photos pour avoir une page.',
  panelFailed: (why: string) => `Une case n’a pas pu être dessinée : ${why}`,
  partMissing: 'Cette partie d’Inkpanel n’a pas pu être chargée. Vérifiez la connexion et réessayez.',
  notDone: (why: string) => `Cela n’a pas pu se faire : ${why}`,
  coreFailed: (why: string) => `Inkpanel n’a pas pu démarrer : ${why}`,
  locked: {
    layout: 'Le gabarit est verrouillé.',
    style: 'Le style est verrouillé.',
    photos: 'Les photos sont verrouillées.',
  },
};
