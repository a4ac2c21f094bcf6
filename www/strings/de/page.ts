export const pageStrings = {
  pageSettings: 'Seiteneinstellungen',
  pageSize: 'Seitenformat',
  gutter: 'Steg',
  margin: 'Seitenrand',
  border: 'Rahmen',
  cornerRadius: 'Eckenradius',
  paper: 'Papierfarbe',
  borderColor: 'Rahmenfarbe',
  size: {
    a4: 'A4',
    'a4-landscape': 'A4 quer',
    letter: 'Letter',
    square: 'Quadrat',
    wide: 'Bildschirm 16:9',
    story: 'Story 9:16',
    portrait: 'Hochformat 4:5',
    webtoon: 'Webtoon',
    custom: 'Eigenes',
  },

  customSize: { width: 'Breite', height: 'Höhe', dpi: 'dpi', unit: 'Einheit' },
  units: { px: 'px', mm: 'mm', in: 'Zoll' },
  wrongSize: {
    side: 'Eine Seite muss zwischen 64 und 14.000 Pixeln lang sein.',
    pixels: 'Die Seite darf höchstens 72 Millionen Pixel haben.',
    dpi: 'Die Punkte je Zoll müssen zwischen 36 und 1200 liegen.',
  },
};
