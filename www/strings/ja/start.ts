export const startStrings = {
  lead: ['写真をドロップ。', 'マンガのページに。'],
  leadMore: 'Inkpanelが写真を選び、切り抜き、ペンを入れて並べます。気に入るまでシャッフルしましょう。',
  chooseFiles: '写真か動画を選ぶ',
  filesLabel: '写真または動画',
  trySamples: 'サンプルアルバムを試す',
  startPages: 'サンプルアルバムから作った3枚のコミックページ',
  recentProjects: '最近のプロジェクト',
  privacy: '何もこの端末の外に出ません。',
  dropHere: 'ドロップして写真を追加',
  framed: 'クリックジャッキングを防ぐため、Inkpanelはほかのサイトの中では動作しません。',
  openInTab: 'Inkpanelを新しいタブで開く',
  starting: 'Inkpanelを起動しています',
};
