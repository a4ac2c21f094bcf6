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
  filesSkipped: (n: number) => `システムやプログラムが写真のそばに置くファイルを${n}個とばしました。`,
  /** `remedy`: a request to the user */
  unsupportedKind: (name: string, remedy: string) => `この種類のファイル（${name}）は読み込めません。${remedy}`,
  remedies: {
    jpeg: '開けるプログラムでJPEGとして保存してください。',
    unpack: '展開して中の画像を追加するか、画像をZIPにまとめてください。',
    pages: 'ページをPNGまたはJPEGで保存してください。',
    mp4: 'H.264のMP4に変換してください。',
    srt: 'SRTまたはWebVTTに変換してください。',
    fountain: 'Fountainとして書き出してください。',
    csv: 'CSVとして保存してください。',
    text: 'プレーンテキストとして保存してください。',
  },
  boardFile: '脚本または表です。ストーリーボードを開いて「脚本や表を読み込む」を選んでください。',
  liveVideos: (n: number) => `Live Photosの動画${n}本は追加していません。写真は追加しました。`,
  addLiveVideos: (_n: number): string => '動画を追加',
};
