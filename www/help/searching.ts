/** The help that is searched for: whatever the case, and with accents or without. */

import { controlNames } from './controls.ts';
import type { Messages } from '../strings/compiled/help-en.ts';
import type { strings } from '../strings/strings.ts';
import type { KeyLine } from './key-lines.ts';

export type Topic = { id: string; title: string; text: string };

/** @param said has the names of controls, in the language of the topics */
export function topicsOf(topics: Messages, said: typeof strings): Topic[] {
  const names = controlNames(said);
  return Object.entries(topics).map(([id, { title, text }]) => ({
    id,
    title,
    text: typeof text === 'string' ? text : text(names),
  }));
}

/**
 * @param sought search words; topics with all of them match, and an empty search matches nothing
 * @returns topics that have them in the title first
 */
export function searchHelp(
  sought: string,
  topics: readonly Topic[],
  lines: readonly KeyLine[],
): { topics: Topic[]; lines: KeyLine[] } {
  const words = plain(sought)
    .split(/\s+/)
    .filter((word) => word !== '');
  const has = (text: string) => words.every((word) => plain(text).includes(word));
  const begins = (text: string) => words.every((word) => beginsIn(plain(text), word));
  const found = topics.filter(({ title, text }) => has(`${title} ${text}`));
  // Matches at the start of a word are preferred: "lock" should not find "block". Without any, parts of compounds
  // count.
  const near = found.filter(({ title, text }) => begins(`${title} ${text}`));
  return {
    topics: [...(near.length > 0 ? near : found)].sort((a, b) => Number(has(b.title)) - Number(has(a.title))),
    lines: lines.filter(({ keys, does }) => has(`${does} ${keys.join(' ')}`)),
  };
}

/**
 * @returns whether a word of the text starts with the search word. In scripts without spaces, whether the text contains
 * it
 */
function beginsIn(text: string, word: string): boolean {
  if (!/^\p{Script=Latin}/u.test(word)) return text.includes(word);
  for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1))
    if (!/[\p{L}\p{N}]$/u.test(text.slice(0, at))) return true;
  return false;
}

/** Removes accents from letters. A voiced kana is a different letter, so it does not change. */
function plain(text: string): string {
  return text
    .normalize('NFKD')
    .replace(/[\u0300-\u036f]/g, '')
    .normalize('NFC')
    .toLocaleLowerCase()
    .replaceAll('ß', 'ss')
    .replaceAll('œ', 'oe')
    .replaceAll('’', "'");
}
