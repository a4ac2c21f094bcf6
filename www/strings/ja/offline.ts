export const offlineStrings = {
  newVersion: '新しいバージョンがあります。',
  reload: '再読み込み',
  notReloaded: '作業が保存されていないため、再読み込みしませんでした。',
  install: 'インストール',
  installHelp: 'Inkpanelを専用のウィンドウで開きます。接続がなくても使えます',
  sharedLost:
    '共有されたものが届きませんでした。ブラウザーの保存領域がいっぱいかもしれません。写真をここに追加してください。',
  launchFailed: (name: string) => `${name}を開けませんでした。ここに追加してください。`,
  noDetectorOffline: '顔の検出は一度ダウンロードが必要です。オンラインになるまでは、コントラストで切り抜きます。',
};
