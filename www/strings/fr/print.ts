/** Mots de l’impression : feuilles, fond perdu, plaques et le contrôle qui précède. */

export const printStrings = {
  print: {
    moreSizes: 'Autres formats',
    purpose: {
      paper: 'Papier',
      book: 'Livres',
      screen: 'Écrans',
    },
    showSafe: 'Montrer la zone sûre',
    safeHelp: 'Visages et mots à l’intérieur de la ligne ne sont jamais coupés. Elle n’est dans aucun fichier.',
    bleed: 'Fond perdu',
    bleeds: {
      none: 'Aucun',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 po',
    },
    bleedHelp:
      'Les cases du bord se prolongent au-delà, pour qu’aucun blanc n’apparaisse à la coupe. Avec une marge, c’est la couleur du papier.',
    marks: 'Traits de coupe',
    sheets: 'Feuilles',
    impositions: {
      none: 'Une page chacune',
      booklet: 'Livret à plier et agrafer',
      zine: 'Mini-zine, huit pages d’une feuille',
      twoUp: 'Deux pages à découper',
      spreads: 'Doubles pages',
    },
    booklet: 'Imprimez recto verso, retourné sur le petit côté. Pliez une fois et agrafez dans le pli.',
    zine: 'Imprimez d’un côté. Pliez en huit, coupez le milieu le long du pli, rapprochez.',
    twoUp: 'Imprimez, puis coupez entre les pages.',
    spreads: 'La première page seule, puis deux par deux comme un livre ouvert.',
    blanks: (n: number) => `${n === 1 ? 'Une page reste vide' : `${n} pages restent vides`}.`,
    paperSize: 'Papier',
    papers: {
      none: 'À la taille des pages',
      a4: 'A4',
      a3: 'A3',
      letter: 'Letter',
      tabloid: 'Tabloïd',
    },
    plates: 'Plaques pour riso ou sérigraphie',
    platesHelp: 'Un PDF gris par encre, réunis dans un ZIP.',
    inks: {
      red: 'rouge',
      blue: 'bleu',
      pink: 'rose',
      teal: 'sarcelle',
      orange: 'orange',
      navy: 'bleu marine',
      coral: 'corail',
      green: 'vert',
      yellow: 'jaune',
      cyan: 'cyan',
      magenta: 'magenta',
      violet: 'violet',
      black: 'noir',
    },
    coarse: (n: number, dpi: number) =>
      `${n === 1 ? 'Une case a' : `${n} cases ont`} moins de ${dpi} ppp à cette taille ; à l’impression, cela peut paraître flou :`,
    coarsePanel: (n: number, dpi: number) => `Case ${n} : ${dpi} ppp`,
    coarseOn: (page: number, n: number, dpi: number) => `Page ${page}, case ${n} : ${dpi} ppp`,
    coarseMore: (n: number) => `et ${n} de plus`,
    enlarge: 'Bien agrandir',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'La photo de cette case est agrandie avec des contours plus nets. Elle ne gagne aucun détail qu’elle n’a pas.'
        : `Les photos de ces ${n} cases sont agrandies avec des contours plus nets. Elles ne gagnent aucun détail qu’elles n’ont pas.`,
    coarseMark: (dpi: number) => `${dpi} ppp`,
    coarseHelp: 'Montrez la photo plus petite ou moins rognée, ou prenez-en une plus grande.',
    coarseHide: 'Masquer les repères',
  },
};
