export const pageStrings = {
  pageSettings: 'Ajustes de página',
  pageSize: 'Formato',
  gutter: 'Calle',
  margin: 'Margen',
  border: 'Borde',
  cornerRadius: 'Esquinas',
  paper: 'Color del papel',
  borderColor: 'Color del borde',
  size: {
    a4: 'A4',
    'a4-landscape': 'A4 apaisado',
    letter: 'Carta',
    square: 'Cuadrado',
    wide: 'Pantalla 16:9',
    story: 'Historia 9:16',
    portrait: 'Retrato 4:5',
    webtoon: 'Webtoon',
    custom: 'A medida',
  },

  customSize: { width: 'Ancho', height: 'Alto', dpi: 'ppp', unit: 'Unidad' },
  units: { px: 'px', mm: 'mm', in: 'pulg.' },
  wrongSize: {
    side: 'Un lado debe tener de 64 a 14 000 píxeles.',
    pixels: 'La página debe tener 72 millones de píxeles como mucho.',
    dpi: 'Los puntos por pulgada deben ir de 36 a 1200.',
  },
};
