type Kind = 'caption' | 'balloon' | 'effect';

export const wordStrings = {
  words: 'Texte',
  addWord: { caption: 'Ajouter un cartouche', balloon: 'Ajouter une bulle', effect: 'Ajouter une onomatopée' },
  wordShort: { caption: 'Cartouche', balloon: 'Bulle', effect: 'Bruit' },
  /** Text of a new item. */
  wordSample: { caption: 'Pendant ce temps…', balloon: 'Salut !', effect: 'BOUM !' },
  wordKind: { caption: 'Cartouche', balloon: 'Bulle', effect: 'Onomatopée' },
  word: (kind: Kind, text: string) => `${wordStrings.wordKind[kind]} : ${text}`,
  wordKeys: 'Entrée modifie le texte, les flèches le déplacent, Suppr le retire',
  wordText: (name: string) => `Texte de ${name}`,
  wordTail: (name: string) => `Queue de ${name}`,
  tailKeys: 'Les flèches déplacent la pointe de la queue',
  wordList: 'Textes de la page',
  narration: 'Titre et légendes',
  narrationHelp: 'Les nouvelles pages portent le nom de l’album et des légendes avec dates, heures et lieux.',
  noWords: 'Pas encore de texte.',
  shape: 'Forme',
  shapes: { oval: 'Parole', thought: 'Pensée', shout: 'Cri', whisper: 'Murmure', radio: 'Radio' },
  editWord: 'Modifier le texte',
  formatWord: 'Format',
  moveWord: 'Déplacer vers…',
  pointTail: 'Pointer la queue vers…',
  removeTail: 'Retirer la queue',
  placeWord: 'Position auto',
  removeWord: 'Retirer le texte',
  wordX: 'X',
  wordY: 'Y',
  wordWidth: 'Largeur',
  wordSize: 'Taille',
  wordAuto: 'automatique',
  wordAngle: 'Angle',
  wordArc: 'Arc',
  wordColor: 'Couleur',
  wordFill: 'Fond',
  wordFont: 'Police',
  fonts: { 'comic-neue': 'Comic Neue', 'comic-neue-bold': 'Comic Neue gras', bangers: 'Bangers' },
  wordCut: 'Le texte ne tenait pas et a été coupé.',
  wordModes: { move: 'Cliquez là où il va', tail: 'Cliquez sur ce qu’elle montre' },
  wordRemoved: (name: string) => `${name} : retiré.`,
  wordsFull: (most: number) => `Une page peut avoir ${most} textes au plus. Retirez-en avant d’en ajouter.`,
  wordsFailed: (why: string) => `Les textes n’ont pas pu être dessinés : ${why}`,

  // Subtitles
  addSubtitles: 'Ajouter des sous-titres',
  subtitlesFile: 'Fichier de sous-titres',
  subtitlesAs: 'En',
  subtitlesKinds: { caption: 'Cartouches', balloon: 'Bulles' },
  subtitlesNoFrames: 'il n’y a pas encore de page. Ajoutez d’abord des photos ou la vidéo.',
  subtitlesNoMatch: 'aucun sous-titre n’est proche du moment d’une image.',
  subtitlesLeft: (n: number, of: number) =>
    `${of} sous-titres ont été lus ; ${n} de plus ${n < 2 ? 'était de trop et a été laissé' : 'étaient de trop et ont été laissés'} de côté.`,
  subtitlesCut: (n: number) =>
    n < 2
      ? 'un sous-titre est trop long, sa fin a donc été laissée de côté.'
      : `${n} sous-titres sont trop longs, leur fin a donc été laissée de côté.`,
  subtitleErrors: {
    empty: 'il ne contient aucun sous-titre.',
    binary: 'ce n’est pas un texte lisible.',
    large: 'il dépasse 5 Mo.',
    time: (line: number, text: string) =>
      `ligne ${line} : « ${text} » n’est pas un temps comme 00:01:02,500 --> 00:01:04,000.`,
    order: (line: number) => `ligne ${line} : le sous-titre finit avant de commencer.`,
    header: 'il ne commence pas par WEBVTT.',
    stray: (line: number, text: string) => `ligne ${line} : un temps était attendu, pas « ${text} ».`,
  },
};
