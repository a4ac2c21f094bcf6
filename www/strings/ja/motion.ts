export const motionStrings = {
  motion: {
    help: 'ページを映像にします。まず全体、次にコマごとに映し、セリフは読む順に現れます。',
    seconds: '1 コマの秒数',
    change: 'ページの切り替え',
    preview: '動くページ',
    living: '動画のコマを動かす',
    larger: '1 コマごとにファイルが最大 2 MB 大きくなります。',
    apart: 'このスタイルは人物を別に描くため、コマは動きません。',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${of} のうち ${time}、${page} ページ、コマ ${panel}` : `${of} のうち ${time}、${page} ページ`,
    facts: (pages: number, length: string, fps: string) => `${pages} ページ、${length}、毎秒 ${fps} フレーム`,
    planning: 'ページを並べています…',
    failed: (why: string) => `動くページを組み立てられません：${why}`,
    making: (percent: string) => `動くページを作成中、${percent}`,
    saved: '動くページを保存しました。',
  },
};
