export const startStrings = {
  lead: ['写真をドロップ。', 'マンガのページに。'],
  leadMore: 'Inkpanelが写真を選び、切り抜き、ペンを入れて並べます。気に入るまでシャッフルしましょう。',
  chooseFiles: '写真か動画を選ぶ',
  filesLabel: '写真または動画',
  trySamples: 'サンプルアルバムを試す',
  privacy: '何もこの端末の外に出ません。',
  dropHere: 'ドロップして写真を追加',
  framed:
    '別のサイトが、自分のページの中にInkpanelを表示しています。見えないものを押させられないように、そこでは動きません。',
  openInTab: 'Inkpanelを専用のタブで開く',
  starting: 'インクを準備しています',
};
