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
    safeHelp: 'Rien n’est coupé à l’intérieur de cette ligne. La ligne n’est pas exportée.',
    bleed: 'Fond perdu',
    bleeds: {
      none: 'Aucun',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 po',
    },
    bleedHelp:
      'Les cases du bord s’étendent dans le fond perdu, pour qu’aucun bord blanc n’apparaisse à la coupe. Avec une marge, le fond perdu a la couleur du papier.',
    marks: 'Traits de coupe',
    sheets: 'Feuilles',
    impositions: {
      none: 'Une page par feuille',
      booklet: 'Livret à plier et agrafer',
      zine: 'Mini-zine, huit pages d’une feuille',
      twoUp: 'Deux pages par feuille, à découper',
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
    plates: 'Séparations en tons directs (riso, sérigraphie)',
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
    enlarge: 'Agrandir les photos de basse résolution',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'La photo de cette case est agrandie avec des contours plus nets. L’agrandissement n’ajoute aucun détail.'
        : `Les photos de ces ${n} cases sont agrandies avec des contours plus nets. L’agrandissement n’ajoute aucun détail.`,
    coarseMark: (dpi: number) => `${dpi} ppp`,
    coarseHelp: 'Montrez la photo plus petite ou moins rognée, ou prenez-en une plus grande.',
    coarseHide: 'Masquer les alertes de résolution',
  },
};
