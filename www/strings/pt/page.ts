export const pageStrings = {
  pageSettings: 'Ajustes da página',
  pageSize: 'Formato',
  gutter: 'Sarjeta',
  margin: 'Margem',
  border: 'Borda',
  cornerRadius: 'Cantos',
  paper: 'Cor do papel',
  borderColor: 'Cor da borda',
  size: {
    a4: 'A4',
    'a4-landscape': 'A4 paisagem',
    letter: 'Carta',
    square: 'Quadrado',
    wide: 'Tela 16:9',
    story: 'Story 9:16',
    portrait: 'Retrato 4:5',
    webtoon: 'Webtoon',
    custom: 'Sob medida',
  },

  customSize: { width: 'Largura', height: 'Altura', dpi: 'dpi', unit: 'Unidade' },
  units: { px: 'px', mm: 'mm', in: 'pol.' },
  wrongSize: {
    side: 'Um lado deve ter de 64 a 14.000 pixels.',
    pixels: 'A página deve ter no máximo 72 milhões de pixels.',
    dpi: 'Os pontos por polegada devem ir de 36 a 1200.',
  },
};
