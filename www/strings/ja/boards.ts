/** Words of boards: the list of shots, the sheets, the ways out and in. */

export const boardsStrings = {
  boards: {
    seen: '表示',
    comic: 'コミック',
    board: '絵コンテ',
    sheets: '絵コンテの用紙',
    shots: 'ショット',
    picture: '画像',
    order: '順番',
    columns: { scene: 'シーン', number: 'カット', length: '長さ', action: '内容', dialogue: '台詞', notes: 'メモ' },
    /** the columns of a list that is saved */
    heading: ['シーン', 'カット', '画像', '映像', 'タイムコード', '長さ', 'フレーム', '内容', '台詞', 'メモ'],
    /** on the sheets; `{page}` and `{count}` become numbers */
    labels: { scene: 'シーン', dialogue: '台詞', notes: 'メモ', page: '{page} / {count} ページ' },
    count: (count: number) => (count === 1 ? '1 ショット' : `${count} ショット`),
    shot: (number: string) => `ショット ${number}`,
    up: (number: string) => `ショット ${number} を上へ`,
    down: (number: string) => `ショット ${number} を下へ`,
    help: 'Enter で次のショット、Tab で次の欄へ進み、Escape で入力を取り消します。Alt と矢印キーでショットを動かします。長さは秒（2）、秒とフレーム（2:12）、フレーム（36f）で書きます。表計算のセルを貼り付けられます。',
    dragHelp: 'ドラッグすると順番を変えられます。',
    copy: '一覧をコピー',
    copied: '一覧を表計算用にクリップボードへ入れました。',
    newColumn: '新しい列',
    addColumn: '列を追加',
    removeColumn: (name: string) => `列「${name}」を削除`,
    noLength: (text: string) =>
      `「${text}」は長さではありません。秒（2）、秒とフレーム（2:12）、フレーム（36f）で書いてください。`,
    pasteLost: (count: number) =>
      count === 1
        ? '貼り付けたセル 1 個の置き場所がありませんでした。'
        : `貼り付けたセル ${count} 個の置き場所がありませんでした。`,
    filmBoard: '映画の絵コンテ',
    perSheet: '1 枚のコマ数',
    aspect: '縦横比',
    rate: '1 秒のフレーム数',
    beside: '文字をコマの横に',
    ruled: 'ワークシート（書き込み用の線）',
    author: '作者',
    date: '日付',
    logo: 'ロゴ',
    chooseLogo: 'ロゴを選ぶ',
    removeLogo: 'ロゴを外す',
    logoFile: 'ロゴの画像',
    noLogo: (name: string) =>
      `${name} はブラウザーで表示できる画像ではありません。PNG、JPEG、WebP、SVG のファイルを選んでください。`,
    brokenLogo: 'ロゴを読み込めません。外すか、別のロゴを選んでください。',
    saveAs: '保存形式',
    saveBoard: '絵コンテを保存',
    ways: { pdf: '絵コンテ、PDF', zip: '絵コンテ、ZIP 内の PNG' },
    importFile: '脚本や表を読み込む',
    tooLarge: (name: string) => `${name} は脚本や表としては大きすぎます。`,
    nothingIn: (name: string) => `${name} にはショットに合うものがありません。`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name}：1 ショットに書き込みました。` : `${name}：${count} ショットに書き込みました。`,
    quoted: (text: string) => `「${text}」`,
    left: (count: number, lines: string) =>
      count === 1 ? `1 行に合うショットがありません：${lines}。` : `${count} 行に合うショットがありません：${lines}。`,
    cellsLeft: (count: number, cells: string) =>
      count === 1 ? `セル 1 個を省くか短くしました：${cells}。` : `セル ${count} 個を省くか短くしました：${cells}。`,
    columnsLeft: (columns: string) => `絵コンテに入らない列があります：${columns}。`,
    noSheets: (why: string) => `絵コンテを作れませんでした：${why}`,
    missing: '絵コンテを表示する部分を読み込めませんでした。もう一度試してください。',
    sheet: (n: number, of: number) => `${of} 枚中 ${n} 枚目`,
    listSaved: 'ショットの一覧を保存しました。',
    listHelp: 'アルバムのすべてのショットと書き込みを、絵コンテの順番で。',
  },
};
