export const keyStrings = {
  letterKeys: '文字キーだけのショートカットを使う',
  // As the keyboard calls them; what is called alike everywhere is not here.
  keyNames: {
    Ctrl: 'Ctrl',
    Space: 'スペース',
    Shift: 'Shift',
    Enter: 'Enter',
    PageUp: 'Page Up',
    PageDown: 'Page Down',
  },
  // What the list says of keys that are no action with a name of its own.
  keyAbout: {
    walk: 'コマからコマへ移る',
    turn: 'ページを切り替える',
    frame: 'コマの写真を矢印キーで動かす',
    scrub: '動画の前後のフレーム（Shiftキーで1秒ずつ）',
    zoom: 'コマの写真を拡大・縮小、リセット',
    choose: 'コマを選択する',
    slant: 'レイアウトの境界線を傾ける',
    list: 'この一覧',
  },
};
