export const pageStrings = {
  pageSettings: 'Réglages de la page',
  pageSize: 'Format',
  gutter: 'Gouttière',
  margin: 'Marge',
  border: 'Contour',
  cornerRadius: 'Coins arrondis',
  paper: 'Couleur du papier',
  borderColor: 'Couleur du contour',
  size: {
    a4: 'A4',
    'a4-landscape': 'A4 paysage',
    letter: 'Letter',
    square: 'Carré',
    wide: 'Écran 16:9',
    story: 'Story 9:16',
    portrait: 'Portrait 4:5',
    webtoon: 'Webtoon',
    custom: 'Sur mesure',
  },

  customSize: { width: 'Largeur', height: 'Hauteur', dpi: 'ppp', unit: 'Unité' },
  units: { px: 'px', mm: 'mm', in: 'po' },
  wrongSize: {
    side: 'Un côté doit mesurer de 64 à 14 000 pixels.',
    pixels: 'La page doit avoir 72 millions de pixels au plus.',
    dpi: 'Les points par pouce doivent aller de 36 à 1200.',
  },
};
