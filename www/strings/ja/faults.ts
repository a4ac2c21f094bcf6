export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}：${why}`,
  filesFailed: (n: number) => `${n}個のファイルを読み込めませんでした。`,
  internalError: (what: string) => `内部エラーが発生しました：${what}`,
  showList: '一覧を見る',
  moreFiles: (n: number) => `ほか${n}個`,
  /** The core's own sentences are English, so all its codes are here. */
  reasons: {
    'animatic-encoder': 'ブラウザーがエンコードを中断しました。小さいサイズか別の形式を選んでください。',
    'animatic-long': 'GIF ファイルは 1 分までです。MP4 か WebM を選ぶか、ショットを短くしてください。',
    'animatic-sound': 'このブラウザーはその形式に音を入れられません。WebM を選ぶか、音を外してください。',
    'sound-unread': 'ブラウザーが音を読めません。MP3 か WAV に変換してください。',
    'film-cut': 'ファイルが不完全です（索引がありません）。元のファイルからもう一度コピーしてください。',
    'film-empty': 'フレームがありません。',
    'films-missing': '動画の読み込み機能を取得できませんでした。接続を確認してもう一度お試しください。',
    'texts-missing': 'テキストファイルの読み込み機能を取得できませんでした。接続を確認してもう一度お試しください。',
    'worker-lost': '読み込み中にInkpanelが2回クラッシュしたため、除外しました。',
    'unreadable-file': '選んだあとでファイルが移動、変更、または削除されました。',
    'not-text': 'テキストファイルではないか、文字コードが不明です。UTF-8で保存してください。',
    'unreadable-entry': 'ブラウザーで読み込めません。オンラインにしかないか、リンクが切れている可能性があります。',
    'unreadable-folder': 'このフォルダーの一部のファイルをブラウザーで読み込めません。',
    'unknown-format': 'Inkpanelが読める画像（JPEG、PNG、WebP、GIF、BMP、TIFF）ではありません。',
    damaged: 'ファイルが壊れているか、不完全です。',
    unsupported: 'この種類のファイルは読み込めません。',
    'too-large': '大きすぎます。',
    'no-decoder':
      'このブラウザーではこの種類の写真を読めません。JPEGで保存するか、別のブラウザーでこのページを開いてください。',
    'no-room': 'ブラウザーに写真を置く空きがありません。',
    'missing-photo': '写真が読み込まれていません。',
    'no-photos': '使える写真がありません。',
    encode: 'ページを画像にできませんでした。',
    'video-codec': 'このブラウザーでは動画をデコードできません。',
    'video-decoder': 'このブラウザーでは動画をデコードできません。',
    'video-format': '完全なMP4、MOV、WebM、Matroskaの動画ではありません。',
    'video-empty': '映像がなく、音声だけです。',
    'video-memory': 'フレームのためのメモリーが足りません。',
    'video-worker': '動画の読み込みが止まりました。',
    'words-missing': '文字を読み込めませんでした。',
    'files-missing':
      'この種類のファイルを作るプログラムを取得できませんでした。もう一度試すか、PNG で保存してください。',
    'decoders-missing': 'この写真を読むためのプログラムを取得できませんでした。接続を確認してもう一度お試しください。',
    'painters-missing': '画家のモデルを取得できませんでした。接続を確認してもう一度お試しください。',
    'core-missing': 'プログラムを読み込めませんでした。',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n}個のファイルを除外しました：1つのプロジェクトに入る写真は${most}枚までです。`,
  /** Reasons by error code that name the kind of file. */
  reasonsOf: {
    'film-container': (what: string) =>
      `Inkpanelはこの動画形式（${what}）を読み込めません。HandBrakeやffmpegなどで、H.264のMP4に変換してください。`,
    'film-codec': (what: string) =>
      `映像が${what}で、このブラウザーではデコードできません。HandBrakeやffmpegなどで、H.264のMP4に変換してください。`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) => `${name}：画像の${share}が壊れているため、灰色で描きます。`,
  photoCoarse: (name: string, share: string) =>
    `${name}：ファイルが壊れているか不完全なため、画像の${share}で細部が欠けています。`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name}は不完全で、${whole}のうち${till}で終わっています。フレームはすべてこの部分から取られています。`,
  noUsablePhoto:
    '使えるファイルがありませんでした。JPEG、PNG、WebP、AVIF、GIF、BMP、TIFFの写真、または動画を選んでください。',
  noSamples: 'サンプルアルバムを読み込めませんでした。接続を確認してもう一度お試しください。',
  noPhotosInUse: '使っている写真がありません。「写真」で1枚チェックするとページができます。',
  panelFailed: (why: string) => `コマを描けませんでした：${why}`,
  partMissing: 'Inkpanelのこの部分を読み込めませんでした。接続を確認してもう一度お試しください。',
  notDone: (why: string) => `できませんでした：${why}`,
  coreFailed: (why: string) => `Inkpanelを起動できませんでした：${why}`,
  locked: {
    layout: 'レイアウトはロックされています。',
    style: 'スタイルはロックされています。',
    photos: '写真はロックされています。',
  },
};
