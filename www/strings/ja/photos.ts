export const photoStrings = {
  photos: '写真',
  usePhoto: (name: string) => `${name}を使う`,
  pickPhoto: (name: string) => `${name}を選ぶ`,
  pickLong: 'クリックすると、選んだコマか次にクリックしたコマに入ります。コマへドラッグもできます',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) => (page === null ? `コマ${panel}` : `${page}ページのコマ${panel}`),
  youLeftOut: 'あなたが除外しました',
  leftOut: (name: string) => `${name}を除外しました。`,
  starPhoto: (name: string) => `${name}にスターを付ける`,
  starLong: 'この写真のコマを大きくし、シャッフルでも大きく見せます',
  starLocked: '写真にスターを付けました。レイアウトまたはコマがロックされているため、コマの大きさは変わりません。',
  starKeepsSize:
    '写真にスターを付けました。このレイアウトではコマを大きくできません。シャッフルすると写真が大きく表示されます。',
  removePhoto: (name: string) => `${name}を削除`,
  photoMissing: 'なし',
  addPhotos: '写真を追加',
  kept: '使用中',
  unseen: {
    waits: 'まだ使われていません',
    text: '文字のページに見えるため使われていません',
    small: '画素が少なすぎるため使われていません',
  },
  setAside: '除外',
  setAsideWhy: '似た写真とピンぼけの写真です。チェックすると使えます。',
  choice: '写真の選び方',
  alike: '似た写真を除外',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}、ほぼ同じ`
      : bits < 11
        ? `${bits}、同じ構図`
        : bits < 14
          ? `${bits}、よく似ている`
          : `${bits}、少し似ている`,
  alikeKept: (kept: number, all: number) => `${all}枚中${kept}枚を使用`,
  order: '順番',
  orders: { time: '撮影日時順', name: 'ファイル名順' },
  stackWhy: 'よく似た写真です。チェックした写真が使われます。増やすことも替えることもできます。',
  stackOf: (count: number) => `似た写真${count}枚`,
  openStack: (count: number, name: string) => `${name}に似た写真${count}枚を見る`,
  take: '使う',
  takeInstead: (name: string) => `代わりに${name}を使う`,
  credit: ({ title, author, licence }: { title: string; author: string; licence: string }) =>
    `${title}（${author}、${licence}）`,
  photoCount: (used: number, all: number) => (used === all ? `${all}` : `${used}／${all}`),
  reading: (done: number, total: number) => `写真を読み込み中：${done}／${total}`,
  cancelReading: '読み込みを中止',

  // Videos
  videos: '動画',
  videoFrames: (count: number) => `${count}フレーム`,
  trimStart: '開始',
  trimEnd: '終了',
  frames: '動画から取るフレーム',
  lookingThrough: (name: string, percent: string) => `${name}を解析しています：${percent}`,
  takeFrames: 'このフレームを使う',

  showSubjects: '見つけたものを表示',
  finding: (done: number, total: number) => `顔と物を検出しています：写真${done}／${total}枚`,
  masking: (done: number, total: number) => `被写体を検出しています：写真${done}／${total}枚`,
  stopMasking: '被写体の検出を停止',
  goOnMasking: '被写体の検出を再開',
  noDetector: 'ここでは顔の検出が使えないため、コントラストで切り抜きます。',
};
