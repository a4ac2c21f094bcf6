export function some(names: readonly string[]) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join('、')}ほか${rest}個` : names.join('、');
}

export const pngStrings = {
  cargo: 'PNGに含めるもの',
  cargoKind: { project: 'プロジェクトのデータ', photos: '写真も', none: '画像だけ' },
  cargoHelp: {
    project: 'このPNGをここにドロップすると、また編集できます。写真はこの端末から探します。',
    photos: '元の写真が入っているので、どの端末でも開けます。ファイルを持つ人は写真を見られます。',
    none: '画像だけです。',
  },
  cargoClean: '写真の場所、日時、カメラの情報は決して入りません。',
  photosUnclean: (n: number) =>
    `中の写真${n}枚には、場所や日時が残っているかもしれません。この種類のファイルからは取り除けません。`,

  noProjectInside: 'プロジェクトのデータのない画像です。',
  pageOpened: (name: string) => `${name}を、独立したプロジェクトとして開きました。`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name}を開きましたが、写真${of}枚のうち${n}枚がこの端末にありません。選ぶかドロップすると、元の場所に戻ります。`,
  photosBack: (n: number) => `写真${n}枚が元の場所に戻りました。`,
  photosStillMissing: (n: number) =>
    `このページの写真がまだ${n}枚ありません。選ぶかドロップすると、元の場所に戻ります。`,
  absentPhoto: (n: number) => `見つからない写真${n}`,
  choosePhotos: '写真を選ぶ',
  openedAsPicture: (name: string) =>
    `${name} をこのプロジェクトの写真として追加しました。そのページの写真はこの端末にありません。`,
  openAsProject: 'プロジェクトとして開く',
  useAsPhoto: '写真として使う',
  backTo: (name: string) => `${name}に戻る`,

  removeMetadata: '位置情報とカメラの情報を取り除く',
  removeMetadataHelp: '人に渡すファイル向けです。日時も取り除かれるため、新しい本で写真を日ごとに並べられません。',
  /** @param unclean: files that kept their metadata; null if no metadata was removed */
  projectSaved: (unclean: readonly string[] | null) =>
    unclean === null
      ? 'プロジェクトをファイルに保存しました。元の写真がそのまま入り、場所、日時、カメラの情報も含まれます。'
      : unclean.length === 0
        ? 'プロジェクトをファイルに保存しました。写真は原寸で入り、場所、日時、カメラの情報は入りません。'
        : `プロジェクトをファイルに保存しました。写真は原寸で入ります。${some(unclean)}には場所や日時が残っているかもしれません。この種類のファイルからは取り除けません。`,
};
