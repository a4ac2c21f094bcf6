export const motionStrings = {
  motion: {
    help: 'ページをモーションコミックとして再生します。まずページ全体、次にコマごとに映し、セリフは読む順に現れます。',
    seconds: '1 コマの秒数',
    change: 'ページの切り替え',
    preview: 'モーションコミック',
    living: '動画のフレームでコマを動かす',
    larger: '1 コマごとにファイルが最大 2 MB 大きくなります。',
    apart: 'このスタイルは人物を別に描くため、コマは動きません。',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${of} のうち ${time}、${page} ページ、コマ ${panel}` : `${of} のうち ${time}、${page} ページ`,
    facts: (pages: number, length: string, fps: string) => `${pages} ページ、${length}、毎秒 ${fps} フレーム`,
    planning: 'ページを計画しています…',
    failed: (why: string) => `モーションコミックを作成できませんでした：${why}`,
    making: (percent: string) => `モーションコミックを作成中、${percent}`,
    saved: 'モーションコミックを保存しました。',
  },
};
