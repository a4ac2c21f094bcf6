/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'ファイルに含めるもの',
  cargoFileHelp: {
    project: 'ファイルをここにドロップすると、また編集できます。写真はこのデバイスから探します。',
    photos: '元の写真が入っているので、どのデバイスでも開けます。ファイルを持つ人は写真を見られます。',
    none: 'ページだけです。',
  },
  packingPhotos: (percent: string) => `写真を入れています、${percent}`,
  photosTooLarge: '写真を合わせるとPNGには大きすぎます。代わりにプロジェクトをファイルに保存してください。',
  savingProject: (done: number, total: number) => `プロジェクトを保存中、${total}個中${Math.floor(done)}個のファイル`,
  damagedInArchive: (archive: string) => `${archive}の中で壊れています。`,
  noPicturesInside: '中に画像がありません。',
  unknownJson: 'Inkpanelのレイアウトでもスタイルでもありません。',
};
