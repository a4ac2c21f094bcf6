/** Words that describe what is on the page to who does not see it, and the page's language. */

import type { Counted, Seen } from '../compose.ts';

/** Many of what takes more than an s. */
const MANY: Record<string, string> = {
  person: 'people',
  bus: 'buses',
  'stop sign': 'stop signs',
  bench: 'benches',
  sheep: 'sheep',
  skis: 'pairs of skis',
  'wine glass': 'wine glasses',
  knife: 'knives',
  sandwich: 'sandwiches',
  broccoli: 'heads of broccoli',
  couch: 'couches',
  mouse: 'computer mice',
  lettering: 'lines of lettering',
  toothbrush: 'toothbrushes',
  scissors: 'pairs of scissors',
};
/** One of what takes more than an article. */
const ONE: Record<string, string> = {
  skis: 'a pair of skis',
  scissors: 'a pair of scissors',
  broccoli: 'broccoli',
  mouse: 'a computer mouse',
  lettering: 'lettering',
  tv: 'a television',
  remote: 'a remote control',
};
const NUMBERS = ['', '', 'two', 'three', 'four', 'five', 'six', 'seven', 'eight', 'nine', 'ten', 'eleven', 'twelve'];

export const describingStrings = {
  /** @returns `two people`, `a dog` */
  thing: ({ label, count }: Seen, counted: Counted) => {
    const one = ONE[label] ?? `${/^[aeiou]/.test(label) ? 'an' : 'a'} ${label}`;
    return counted(count, [one, MANY[label] ?? `${label}s`], NUMBERS);
  },
  pageHolds: (panels: number, layout: string, style: string) =>
    `${panels === 1 ? 'One panel' : `${panels} panels`}, layout ${layout}, style ${style}`,
  panelHolds: (n: number, what: string) => `Panel ${n}: ${what}.`,
  /** The beginning of a text that stands for the page elsewhere. */
  pageAs: (panels: number, style: string) =>
    `A storyboard page of ${panels === 1 ? 'one panel' : `${panels} panels`} in the style ${style}.`,
  wordSays: (kind: string, text: string) => `${kind}: “${text}”.`,
  somePhoto: 'a photo',
  emptyPanel: 'empty',
  ownLayout: 'of your own',
  ownStyle: 'of your own',
  description: 'Description of the page',
  copyDescription: 'Copy description',
  descriptionHelp: 'For those who cannot see it, wherever you show the page.',
  descriptionCopied: 'The description is in the clipboard.',
  descriptionNotCopied: (text: string) => `The clipboard cannot be used here. The description is: ${text}`,

  language: 'Language',
  languageHelp: 'The page loads again in that language. Your work is saved first.',
  languageLater: (name: string) =>
    `${name} is for the next visit: your work is not saved, so the page was not loaded again.`,
};
