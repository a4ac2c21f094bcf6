export const keyStrings = {
  letterKeys: '文字キーだけのショートカットを使う',
  // Labels of the keys. Keys with the same label in every language are missing.
  keyNames: {
    Ctrl: 'Ctrl',
    Space: 'スペース',
    Shift: 'Shift',
    Enter: 'Enter',
    PageUp: 'Page Up',
    PageDown: 'Page Down',
  },
  // Descriptions of keys that belong to no named action.
  keyAbout: {
    walk: 'コマからコマへ移る',
    turn: 'ページを切り替える',
    frame: 'コマの写真を矢印キーで動かす',
    scrub: '動画の前後のフレーム（Shiftキーで1秒ずつ）',
    zoom: 'コマの写真を拡大・縮小、リセット',
    choose: 'コマを選択する',
    slant: 'レイアウトの境界線を傾ける',
    sizeInset: 'はめ込みコマの大きさを変える',
    originals: '押している間、元の写真を表示',
    list: 'この一覧',
  },
};
