import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'ブラウザーの保存領域がいっぱいです',
  refused: 'このブラウザーはここでサイトの保存領域をブロックしています',
};

export const storageStrings = {
  // Saving
  saveState: {
    empty: '',
    saving: '保存中…',
    saved: '保存済み',
    missing: '一部未保存',
    full: '未保存',
    refused: '未保存',
    failed: '未保存',
  },
  savingCount: (done: number, total: number) => `保存中：${done}／${total}`,
  saveHelp: '作業はこの端末の、このブラウザーに保存されます',
  notSaved: (why: string, message: string) =>
    `作業が保存されていません：${TROUBLE[why] ?? message.replace(/\.$/, '')}。このタブを閉じると失われます。`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)}：ファイルを読めなくなったため、保存されていません。ほかはすべて保存されています。`,
  photosNotHere: (names: readonly string[], of: number) =>
    `${of}枚の写真のうち${names.length}枚がこのブラウザーにありません：${some(names)}。選ぶかドロップすると、元の場所に戻ります。`,
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)}：このブラウザーに動画はもうありませんが、取り出したフレームは残っています。ほかのフレームを使うには、動画をもう一度追加してください。`,
  photosNeverSaved: (names: readonly string[]) =>
    `${some(names)}を保存する前にアプリが閉じられました。もう一度選んでください。`,
  saveAgain: 'もう一度保存',
  goOnWithout: 'このまま続ける',
  saveToFile: 'ファイルに保存',
  conflict: '別のタブでこのプロジェクトが変更されました。このタブではコピーで続けます。',

  // Projects
  projects: 'プロジェクト',
  projectName: 'プロジェクト名',
  untitled: '名称未設定',
  newProject: '新規プロジェクト',
  openProject: 'プロジェクトファイルを開く',
  saveProject: 'プロジェクトファイルを保存',
  projectFile: 'プロジェクトのファイル',
  openNamed: (name: string) => `${name}を開く`,
  duplicateNamed: (name: string) => `${name}を複製`,
  deleteNamed: (name: string) => `${name}を削除`,
  renameNamed: (name: string) => `${name}の名前を変更`,
  newNameOf: (name: string) => `${name}の新しい名前`,
  sampleAlbum: 'サンプルアルバム',
  openNow: '開いています',
  projectAbout: (photos: number, when: string) => `写真${photos}枚${when && `、${when}`}`,
  noProjects: '作ったものは自動的にここに保存されます。',
  projectDeleted: (name: string) => `${name}を削除しました。`,
  bringBack: '元に戻す',
  projectNotOpened: (why: string) => `プロジェクトを開けませんでした：${why}`,
  projectFileNotOpened: (name: string, why: string) => `${name}を開けませんでした：${why}`,
  projectNotSaved: (why: string) => `プロジェクトをファイルに保存できませんでした：${why}`,
  projectReasons: {
    'damaged-project': '壊れているか、Inkpanelのプロジェクトではありません。ページの内容は変わっていません。',
    'too-large-project': 'プロジェクトの上限を超えています。ページの内容は変わっていません。',
    'silent-project': 'ファイルの読み込みが1分でタイムアウトしました。ドライブを確認して、もう一度お試しください。',
    'newer-project': '新しいバージョンのInkpanelで保存されています。このタブを再読み込みして更新してください。',
    'not-saved': 'ページの内容が保存されていません。先にファイルに保存してください（プロジェクトファイルを保存）。',
    'missing-project': '削除されています。',
    'no-storage': 'このブラウザーはここでサイトの保存領域をブロックしています。',
    'too-large': 'ファイルが4 GBを超えます。',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `${others.length + 1}個のプロジェクトを別々に開きました。${shown}を表示しています。${others.length === 1 ? `${others[0]}` : `ほかの${others.length}個`}は「プロジェクト」にあります。`,
  photosWithProject: (n: number, name: string) => `一緒に渡された写真${n}枚を${name}に追加しました。`,
  projectBroken: (name: string, why: string) => `${name}を表示できません：${why}。`,
  brokenReasons: {
    'damaged-project': '一部が壊れています',
    'too-large-project': 'プロジェクトの上限を超えています',
    'newer-project': '新しいバージョンのInkpanelで保存されています。このタブを再読み込みして更新してください',
  } as Record<string, string>,
  brokenOtherwise: '一部を描けません',
  brokenKept: 'プロジェクトと写真は変わっていません。',
  partsLeftOut: (name: string, n: number) => `読めなかった${n}か所を除いて、${name}を開きました。`,
  openAnother: '別のものを開く',
  saveAsFile: 'ファイルとして保存',
  goBack: '最後の正常なバージョンに戻す',
  noGoodState: '戻せる以前のバージョンはありません。',
  wentBack: (name: string) => `${name}の最後の正常なバージョンを復元しました。`,
  openingProject: (name: string) => `${name}を開いています`,
  openingLast: 'プロジェクトを開いています',
  openElsewhere: (name: string) => `${name}は別のタブで開かれています。`,
  opensWhenFree: 'そのタブを閉じると、ここで開きます。',
  openCopy: 'コピーを開く',

  // Pages shown
  pagesShown: 'ページの履歴',
  pagesShownAt: (n: number, of: number) => `ページの履歴、${n}/${of}`,
  pageNumber: (n: number) => `ページ${n}`,
  versionFrom: (n: number) => `バージョン${n}から`,
  favouritePage: 'お気に入りのページ',
  favouritePages: 'お気に入りだけ',
  versionNumber: (n: number) => `バージョン${n}`,
  compareShort: '比べる',
  comparePage: (n: number) => `バージョン${n}を比べる`,
  comparedAll: 'すべてのバージョンを表示',
  compareSecond: '比べる2つ目のバージョンを選んでください',
  noFavouritePages: 'お気に入りはまだありません。好きなページのハートを押してください。',
};
