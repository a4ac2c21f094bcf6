/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: '絵からスタイルを作る',
  styleFromPictureHelp: '漫画のページ、版画、絵画など、絵の雰囲気をあなたの写真に移します',
  imitationAbout:
    '雰囲気を移したい絵を選んでください。漫画のページ、版画、線画、絵画などです。数秒で、あなたの写真をその雰囲気にするスタイルを探します。絵はこの端末の外に出ません。',
  imitationDropHere: 'または画像をここにドロップします。',
  imitationChoose: '絵を選ぶ',
  imitationOther: '別の絵',
  imitationFile: 'スタイルを探す絵',
  imitationAgain: 'もう一度探す',
  imitationAnyway: 'それでも探す',
  imitating: 'スタイルを探しています…',
  imitationProposals: '見つかったスタイル',
  imitationPhotos: 'プレビューの写真',
  imitationNone: 'この絵に近いスタイルは見つかりませんでした。別の絵で試してください。',
  imitationNeedsPhotos: '先に写真を選んでください。絵のスタイルはその写真で試します。',
  dropForStyle: 'ここに、またはAltキーを押しながらドロップすると、絵のスタイルを取り込みます',
  imitationFound: (n: number) =>
    n === 1
      ? 'スタイルが1つ見つかりました。使う、編集する、保存するとあなたのものになります。'
      : `スタイルが${n}個見つかりました。使う、編集する、保存するとあなたのものになります。`,
  imitationName: (picture: string, place: number) => `${picture}風 ${place}`,
  imitationPictureOf: (name: string) => `絵 ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'この絵は小さすぎます。各辺に64ピクセル以上が必要です。',
    'blank-picture': 'この絵は空白で、スタイルがありません。',
    'plain-photo': 'これは普通の写真のようで、移せる線やインク、絵の具がありません。線画、版画、絵画を選んでください。',
    'imitation-missing': 'スタイルの検索機能を読み込めませんでした。接続を確認してもう一度お試しください。',
    'worker-lost': 'この絵の読み込み中にInkpanelがクラッシュしました。別の絵で試してください。',
    'unreadable-file': '選んだ後にファイルが移動、変更、または削除されました。',
    'unknown-format': '読み込める画像ではありません。JPEG、PNG、WebP、AVIF、GIF、BMP、TIFFのファイルを選んでください。',
    damaged: 'この絵のファイルは壊れているか、途中で切れています。',
    'too-large': 'この絵は大きすぎます。',
  } as Record<string, string>,
};
