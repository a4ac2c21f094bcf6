// @ts-check
/** Words that describe what is on the page to who does not see it, and the page's language. */

/** How many of a kind of thing. @typedef {{ label: string, count: number }} Seen */

/** Many of what takes more than an s. @type {Record<string, string>} */
const MANY = {
  person: 'people', bus: 'buses', 'stop sign': 'stop signs', bench: 'benches', sheep: 'sheep', skis: 'pairs of skis', 'wine glass': 'wine glasses',
  knife: 'knives', sandwich: 'sandwiches', broccoli: 'heads of broccoli', couch: 'couches', mouse: 'computer mice', toothbrush: 'toothbrushes',
  scissors: 'pairs of scissors',
};
/** One of what takes more than an article. @type {Record<string, string>} */
const ONE = {
  skis: 'a pair of skis', scissors: 'a pair of scissors', broccoli: 'broccoli', mouse: 'a computer mouse', tv: 'a television', remote: 'a remote control',
};
const NUMBERS = ['', '', 'two', 'three', 'four', 'five', 'six', 'seven', 'eight', 'nine', 'ten', 'eleven', 'twelve'];

/** @param {Seen} seen */
function several({ label, count }) {
  if (count === 1) return ONE[label] ?? `${/^[aeiou]/.test(label) ? 'an' : 'a'} ${label}`;
  return `${NUMBERS[count] ?? count} ${MANY[label] ?? `${label}s`}`;
}

const list = new Intl.ListFormat('en');

export const describingStrings = {
  /** @param {readonly Seen[]} things `two people and a dog`; empty for nothing */
  seen: (things) => list.format(things.map(several)),
  /** @param {number} panels @param {string} layout @param {string} style */
  pageHolds: (panels, layout, style) => `${panels === 1 ? 'One panel' : `${panels} panels`}, layout ${layout}, style ${style}`,
  panelHolds: (/** @type {number} */ n, /** @type {string} */ what) => `Panel ${n}: ${what}.`,
  /** The beginning of a text that stands for the page elsewhere. @param {number} panels @param {string} style */
  pageAs: (panels, style) => `A storyboard page of ${panels === 1 ? 'one panel' : `${panels} panels`} in the style ${style}.`,
  /** @param {string} kind @param {string} text */
  wordSays: (kind, text) => `${kind}: “${text}”.`,
  somePhoto: 'a photo',
  emptyPanel: 'empty',
  ownLayout: 'of your own',
  ownStyle: 'of your own',
  description: 'Description of the page',
  copyDescription: 'Copy description',
  descriptionHelp: 'For those who cannot see it, wherever you show the page.',
  descriptionCopied: 'The description is in the clipboard.',
  descriptionNotCopied: (/** @type {string} */ text) => `The clipboard cannot be used here. The description is: ${text}`,

  language: 'Language',
  languageHelp: 'The page loads again in that language. Your work is saved first.',
  languageLater: (/** @type {string} */ name) => `${name} is for the next visit: your work is not saved, so the page was not loaded again.`,
};
