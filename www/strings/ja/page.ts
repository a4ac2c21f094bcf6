export const pageStrings = {
  pageSettings: 'ページ設定',
  pageSize: 'ページサイズ',
  gutter: 'コマの間隔',
  margin: '余白',
  border: '枠線',
  cornerRadius: '角の丸み',
  paper: '用紙の色',
  borderColor: '枠線の色',
  size: {
    a4: 'A4',
    'a4-landscape': 'A4横',
    letter: 'レター',
    square: '正方形',
    wide: '画面 16:9',
    story: 'ストーリー 9:16',
    portrait: '縦長 4:5',
    webtoon: 'ウェブトゥーン',
    custom: 'カスタム',
  },

  customSize: { width: '幅', height: '高さ', dpi: '解像度', unit: '単位' },
  units: { px: 'px', mm: 'mm', in: 'インチ' },
  wrongSize: {
    side: '一辺は64～14,000ピクセルにしてください。',
    pixels: 'ページは7,200万ピクセルまでです。',
    dpi: '解像度は36～1200 dpiにしてください。',
  },
};
