/** 印刷の言葉：用紙、塗り足し、版、印刷前の確認。 */

export const printStrings = {
  print: {
    moreSizes: 'ほかのサイズ',
    purpose: {
      paper: '用紙',
      book: '本',
      screen: '画面',
    },
    showSafe: '安全領域を表示',
    safeHelp: 'この線の内側は断裁で切り落とされません。線は書き出されません。',
    bleed: '塗り足し',
    bleeds: {
      none: 'なし',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 インチ',
    },
    bleedHelp: '端のコマが外まで続くので、断裁しても白が出ません。余白があればそこは紙の色です。',
    marks: 'トンボ',
    sheets: '面付け',
    impositions: {
      none: '1枚に1ページ',
      booklet: '折って綴じる冊子',
      zine: 'ミニZINE（1枚から8ページ）',
      twoUp: '1枚に2ページ（切り分け）',
      spreads: '見開き',
    },
    booklet: '短辺とじで両面印刷し、一度折って折り目を綴じます。',
    zine: '片面に印刷し、八つ折りにして中央を折り目に沿って切り、寄せて畳みます。',
    twoUp: '印刷してページの間で切ります。',
    spreads: '最初のページは単独、その後は開いた本のように2ページずつ。',
    blanks: (n: number) => `${n}ページは空白になります。`,
    paperSize: '用紙',
    papers: {
      none: 'ページと同じ大きさ',
      a4: 'A4',
      a3: 'A3',
      letter: 'レター',
      tabloid: 'タブロイド',
    },
    plates: '特色分版（リソグラフ・シルクスクリーン）',
    platesHelp: 'インクごとにグレーのPDFを作り、ZIPにまとめます。',
    inks: {
      red: '赤',
      blue: '青',
      pink: 'ピンク',
      teal: 'ティール',
      orange: 'オレンジ',
      navy: '紺',
      coral: 'コーラル',
      green: '緑',
      yellow: '黄',
      cyan: 'シアン',
      magenta: 'マゼンタ',
      violet: '紫',
      black: '黒',
    },
    coarse: (n: number, dpi: number) =>
      `${n}個のコマがこの大きさで${dpi} dpi未満です。印刷するとぼやけるかもしれません：`,
    coarsePanel: (n: number, dpi: number) => `コマ${n}:${dpi} dpi`,
    coarseOn: (page: number, n: number, dpi: number) => `${page}ページ、コマ${n}:${dpi} dpi`,
    coarseMore: (n: number) => `ほか${n}個`,
    enlarge: '低解像度の写真を拡大',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'このコマの写真は輪郭を保って拡大されます。元の写真にない細部は増えません。'
        : `これらの${n}コマの写真は輪郭を保って拡大されます。元の写真にない細部は増えません。`,
    coarseMark: (dpi: number) => `${dpi} dpi`,
    coarseHelp: '写真を小さく見せるか、切り抜きを広げるか、大きな写真を使ってください。',
    coarseHide: '解像度の警告を隠す',
  },
};
