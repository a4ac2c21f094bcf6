import { boardStrings as board } from './board.ts';
import { bookStrings } from './book.ts';
import { brushStrings } from './brush.ts';
import { designerStrings as designer } from './designer.ts';
import { imitationStrings as imitation } from './imitation.ts';
import { storageStrings as storage } from './storage.ts';
import { offlineStrings } from './offline.ts';
import { panelStrings as panels } from './panels.ts';
import { photoStrings as photos } from './photos.ts';
import { soundStrings } from './sounds.ts';
import { pngStrings } from './png.ts';
import { sideStrings as side } from './side.ts';
import { startStrings } from './start.ts';
import { wordStrings as words } from './words.ts';

const { filmSounds: sounds } = soundStrings;

const { book } = bookStrings;

const { brush } = brushStrings;

export const helpStrings = {
  help: 'ヘルプとキーボードショートカット',
  helpShort: 'ヘルプ',
  searchHelp: 'ヘルプを検索',
  helpTopics: 'トピック',
  helpFound: (topics: number, keys: number) => `見つかったもの：トピック${topics}件、ショートカット${keys}件`,
  helpNone: (text: string) =>
    `「${text}」についての説明は見つかりませんでした。別の言葉で試すか、すべてのトピックをご覧ください。`,
  allTopics: 'すべてのトピックを表示',
  hintsAgain: 'ヒントをもう一度表示',
  hint: {
    shuffle: '気に入るまでシャッフルしましょう。一度見たページはいつでも呼び戻せます。',
    crop: 'ドラッグで写真を動かし、ホイールで拡大・縮小できます。',
    cropTouch: 'ドラッグで写真を動かし、ピンチで拡大・縮小できます。',
    lock: '気に入った部分はロックしましょう。シャッフルで変わるのは残りだけです。',
  },
  topics: {
    adding: {
      title: '写真や動画を追加する',
      text: `写真や動画をウィンドウのどこにでもドロップするか、貼り付けるか、「${photos.addPhotos}」を押してください。まず試したいときは「${startStrings.trySamples}」をどうぞ。あとからいつでも追加できます。`,
    },
    films: {
      title: '動画のフレーム',
      text: `動画からはいくつかのフレームを取り出し、ほかの写真と同じように使います。写真の一覧で動画の名前を押すと、開始と終了、フレームの数を選べます。「${photos.takeFrames}」で取り出します。フレームを見せているコマは、前後のフレームに替えられます。「${side.sideTab.words}」の「${sounds.hear}」は、ページにあるフレームの近くで聞こえる音の描き文字を提案します。`,
    },
    shuffle: {
      title: 'シャッフルする',
      text: `「${board.shuffle}」は、あなたの写真から、別のレイアウトと別のスタイルの新しいページを作ります。横の「${board.part.layout}」「${board.part.style}」「${board.part.photos}」は、その部分だけを変えます。スマートフォンでは、ページを横にスワイプしてもかまいません。`,
    },
    locks: {
      title: '残したいものをロックする',
      text: `「${board.part.layout}」「${board.part.style}」「${board.part.photos}」の横の錠は、ほかをシャッフルする間、その部分をそのままにします。「${panels.lockPanel}」は、1つのコマの写真を切り抜きごと残します。スターを付けた写真は、ここでもシャッフルのたびにも大きく見せます。`,
    },
    versions: {
      title: '前に戻る、お気に入りのページ',
      text: `「${board.undo}」と「${board.redo}」は、した操作を順にたどります。「${board.previous}」と「${board.next}」は、見たページを順にたどります。間の数字を押すと、そのすべてが並びます。ハートはページをお気に入りにします。`,
    },
    ideas: {
      title: 'おすすめ',
      text: `ページの下の帯「${side.moreIdeas}」には、同じ写真で作った別のページが並びます。クリックするとそのページになります。ポインターを重ねると大きく見られます。`,
    },
    layouts: {
      title: 'レイアウト',
      text: `種類とコマ数でレイアウトを選べます。「${side.surprise}」は新しいレイアウトを考え出します。「${side.editLayout}」では、コマの間の境界線をドラッグしたり傾けたり、はめ込みコマを動かしたりでき、コマを分けたり削除したりもできます。「${side.saveLayout}」はファイルに保存し、「${side.myLayouts}」に入れます。`,
    },
    joining: {
      title: 'コマをつなげる、1枚の写真を複数のコマに',
      text: `「${panels.selectPanels}」をオンにして、隣り合うコマを選びます。「${panels.joinPanels}」は、合わせて1つのコマの形になるとき、それらを1つにします。「${panels.merge}」はコマを残したまま、1枚の写真を全体に通します。「${panels.split}」で元どおりに分けられます。`,
    },
    crop: {
      title: '写真を動かす、拡大・縮小する',
      text: `コマの中で写真をドラッグすると動き、ホイールかピンチで拡大・縮小します。指で操作するときは、先にコマをタップしてください。ダブルクリックすると被写体に合わせます。「${panels.resetCrop}」で自動の切り抜きに戻ります。横倒しの写真は「${panels.rotatePhoto}」で起こし、「${panels.flipPhoto}」で左右を反転できます（すべてのページに反映）。`,
    },
    exchange: {
      title: '写真を入れ替える',
      text: `写真をコマの外へ、別のコマの上までドラッグすると、2枚が入れ替わります。「${panels.swapPhoto}」ならクリックで同じことができます。一覧の写真をクリックしてからコマをクリックすると、写真がそこに入ります。一覧の写真のチェックを外すと、使われなくなります。`,
    },
    subject: {
      title: '被写体を直す',
      text: `「${panels.breakFrame}」、被写体や背景だけのスタイル、体を避けて置かれるテキストは、検出された被写体をもとにしています。それが違うときは、コマの道具の「${brush.correct}」か、一覧でクリックした写真のブラシで開きます。被写体に入る部分を塗り、入らない部分を取り除くか、別の被写体を選びます。「${brush.found}」で検出された被写体に戻ります。`,
    },
    styles: {
      title: 'スタイル',
      text: `どのスタイルも、あなたの写真で見られます。名前で検索するか、種類を選んでください。お気に入りと最近使ったものが先に並びます。「${designer.styleShuffle}」では、「${board.shuffle}」が何から選ぶかを決められます。`,
    },
    designer: {
      title: 'スタイルを作る：デザイナー',
      text: `スタイルには色の層と線の層の2つがあり、それぞれがブロックの列です。「${designer.addBlock}」で加え、スライダーで調整し、「${designer.compare}」で違いを確かめます。ブロックは好きな場所へドラッグするか、カードの間の＋で挿入します。「${designer.saveStyle}」で「${designer.myStyles}」に入ります。`,
    },
    explorer: {
      title: 'スタイルを見つける：エクスプローラー',
      text: `開くとあなたの写真で考え出したスタイルが並び、「${designer.generate}」でさらに増えます。クリックすると大きく見られます。気に入ったものはハートで残し、「${designer.breed}」で2つから新しいものを作り、「${designer.useStyle}」でページに使います。どれもデザイナーで変えられます。`,
    },
    imitation: {
      title: '絵からスタイルを作る',
      text: `「${imitation.styleFromPicture}」は、漫画のページや版画、絵画の雰囲気をあなたの写真に移します。そこで絵を選ぶか、Altキーを押しながらどこにでもドロップしてください。数秒で、あなたの写真に3〜6個のスタイルが表示されます。使う、保存する、デザイナーで変えることができます。`,
    },
    words: {
      title: 'キャプション、フキダシ、効果音',
      text: `「${side.sideTab.words}」でキャプション、フキダシ、効果音を追加できます。場所があれば、顔を隠さない所に置かれます。ドラッグで動かし、ダブルクリック（指ではもう一度タップ）で書き換えます。動画のせりふも使えます。「${words.addSubtitles}」は字幕ファイルを読み込みます。`,
    },
    alike: {
      title: '似た写真と、除外された写真',
      text: `似た写真のうち一番鮮明なものが使われ、ほかは除外されます。ピンぼけの写真も同じです。「${photos.setAside}」にあり、チェックすると使えます。どのくらい似ていたら除外するかは、「${photos.choice}」で決められます。`,
    },
    pages: {
      title: '複数のページ',
      text: `「${book.add}」は、まだどのページにもない写真があるうちは、それで作ったページを加えます。「${book.spreadAlbum}」は、すべての写真を必要な数のページに並べます。ページは移動も削除もでき、スタイルをそろえることもできます。`,
    },
    paper: {
      title: 'ページサイズと余白',
      text: `ページの設定には、A4から自由な寸法までのサイズ、余白、コマの間隔、枠線、角の丸み、色があります。絵コンテのすべてのページに同じ設定が使われます。`,
    },
    saving: {
      title: '保存',
      text: `作業はこの端末の、このブラウザーに自動で保存され、次に来たときもそのままです。「${storage.projects}」に、名前の付いたすべての作業があります。ブラウザーのデータを消すと失われるので、大切なものはファイルにも残してください。`,
    },
    files: {
      title: 'プロジェクトのファイル',
      text: `「${storage.projects}」の「${storage.saveProject}」は、原寸の写真も含めてすべてを1つのファイルにします。この端末でも別の端末でも、ウィンドウにドロップすれば続けられます。プロジェクトデータ入りのページのPNGも同じように開きます。写真はこの端末から見つけるか、「${pngStrings.cargoKind.photos}」を選んでいれば中に入っています。`,
    },
    export: {
      title: '書き出し：PNG、JPEG、WebP、PDF',
      text: `「${board.download}」は、元の写真から印刷サイズのページを保存します。「${board.export}」では、JPEG、WebP、PDFと、その品質を選べます。複数のページは、PDF、ZIP、またはコミックリーダー用のCBZになります。`,
    },
    comics: {
      title: '読むためのコミック：HTML、EPUB、CBZ',
      text: `「${board.export}」ではコミックも作れます。「HTMLコミック」は、だれでもブラウザーで開ける1つのファイルです。タップ、スワイプ、矢印キーでコマからコマへ進み、ページ全体を見たり、すべてをテキストで読んだりできます。EPUBは読書アプリ用、CBZはコミックリーダー用です。どれもコマの順番と言葉、見つかったものが入っているので、読み上げることができます。`,
    },
    privacy: {
      title: 'オフラインとプライバシー',
      text: `写真がこの端末の外に出ることはありません。作業はすべてこのブラウザーの中で行われ、どこにも何も送られません。顔は、コマで切れないように位置だけを検出し、人物を特定することはありません。写真の位置情報は、文章に場所の名前を入れるためだけに GeoNames の表（CC BY 4.0）で読み取り、書き出したページには入りません。一度開けば接続がなくても使え、ブラウザーが対応していれば、「${offlineStrings.install}」で専用のウィンドウになります。`,
    },
    keyboard: {
      title: 'キーボードで使う',
      text: `すべてマウスなしで操作でき、ショートカットは下に並んでいます。矢印キーでコマからコマへ移り、Enterで写真をつかむと、矢印キーで動かせます。音声で操作する人のために、文字キーだけのショートカットはオフにできます。`,
    },
  },
};
