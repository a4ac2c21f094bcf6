/** Speech that is read from subtitles and scripts. */

import type { Word } from './types.ts';

/** A text item from speech, with the index of its frame or of its panel; `joins` continues the item before. */
export type Spoken = Word & { frame?: number; place?: number; joins?: boolean };
/** Speech laid over panels: text without a `place` is unplaced, and `unplaced` counts all of it, even what is not listed. */
export type Speech = { words: Spoken[]; unplaced: number };
/** Options for speech, and for sounds: sound effects, or dropped. */
export type Taking = { kind: 'caption' | 'balloon'; sounds: boolean };
/** An error in a subtitle file; lines count from 1. */
export type SubtitleFlaw =
  | { kind: 'large' | 'binary' | 'header' | 'empty' }
  | { kind: 'order'; line: number }
  | { kind: 'stray' | 'time'; line: number; text: string };
/**
 * Text items for frames with subtitles close to them. Counts: subtitles that were read, found no frame, were left out,
 * cut or skipped. `flaws`: the first errors.
 */
export type ReadSubtitles =
  | (Speech & {
      cues: number;
      homeless: number;
      left: number;
      cut: number;
      skipped: number;
      flaws: SubtitleFlaw[];
    })
  | { flaw: SubtitleFlaw };
