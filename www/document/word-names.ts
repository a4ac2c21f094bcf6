/** Names of text items, for bars, lists and descriptions. */

import { strings } from '../strings/strings.ts';
import type { Word } from '../engine/types.ts';

/** The font of titles, of a book and of a page. */
export const TITLE_FONT = 'bangers';

/** The role of a text item: its kind. Captions can be page numbers and titles. */
export function roleOf({ kind, number, boxless, font }: Word): keyof typeof strings.wordKind {
  if (number) return 'number';
  return kind === 'caption' && boxless && font === TITLE_FONT ? 'title' : kind;
}

/** @param text as far as it is typed */
export function wordName(word: Word, text = word.text): string {
  return strings.word({ kind: strings.wordKind[roleOf(word)], text });
}
