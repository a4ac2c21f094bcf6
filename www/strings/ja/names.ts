/** What the core and the data files call things, by their ids. */

import { blocks, parameters } from './blocks.ts';
import { layouts } from './layouts.ts';
import { styles } from './styles.ts';
import type { Names } from '../names.ts';

export const names: Names = {
  blocks,
  parameters,
  layouts,
  styles,
  families: {
    cinema: 'シネマ',
    circle: '円',
    columns: '縦割り',
    grid: 'グリッド',
    hero: '大ゴマ',
    inset: 'はめ込み',
    landscape: '横長',
    manga: 'マンガ',
    mosaic: 'モザイク',
    overlap: '重なり',
    rows: '横割り',
    slanted: '斜め',
    splash: '全面',
    square: '正方形',
    strip: 'ストリップ',
    tall: '縦長',
    pop: 'ポップ',
    sketch: 'スケッチ',
    hatch: 'ハッチング',
    halftone: '網点',
    ink: 'インク',
    blueprint: '青写真',
    vintage: 'ビンテージ',
    comic: 'コミック',
    duotone: 'ダブルトーン',
    noir: 'ノワール',
    watercolour: '水彩',
    woodcut: '木版画',
    paper: '紙',
  },
  choices: {
    hatch: 'ハッチング',
    cross_hatch: 'クロスハッチング',
    dots: '点',
    lines: '線',
    woodcut: '木版画',
    stipple: '点描',
    cmyk: 'CMYK',
    mono: '一色',
  },
  verdicts: {
    same: (name) => `${name}と同じ`,
    sharpest: (of) => `${of}枚中で最も鮮明`,
    only: '似た写真なし',
    blurred: 'ピンぼけ',
  },
};
