/** Descriptions of the page for screen readers, and the language of the app. */

import type { Counted, Seen } from '../compose.ts';

/** Irregular plurals of detected things. */
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
/** Irregular singulars of detected things. */
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
  /** First sentence of the alternative text of an exported page. */
  pageAs: (panels: number, style: string) =>
    `A comic page of ${panels === 1 ? 'one panel' : `${panels} panels`} in the style ${style}.`,
  wordSays: (kind: string, text: string) => `${kind}: “${text}”.`,
  somePhoto: 'a photo',
  emptyPanel: 'empty',
  ownLayout: 'custom',
  ownStyle: 'custom',
  description: 'Alt text',
  copyDescription: 'Copy description',
  descriptionHelp: 'For people who cannot see the page, wherever you publish it.',
  descriptionCopied: 'The description was copied to the clipboard.',
  descriptionNotCopied: (text: string) => `The clipboard is not available here. The description is: ${text}`,

  language: 'Language',
  languageHelp: 'The app reloads in that language. Your work is saved first.',
  languageLater: (name: string) =>
    `${name} applies from your next visit. The app did not reload, because your work is not saved.`,
};
