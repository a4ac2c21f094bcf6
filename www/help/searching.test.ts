import { expect, it } from 'vitest';
import { helpIn, inLanguage, translations } from '../strings/testing.ts';
import { searchHelp, topicsOf } from './searching.ts';

const topicsIn = (language: string) => topicsOf(helpIn(language), inLanguage(language));

const TOPICS = [
  { id: 'a', title: 'Café', text: 'Größe und Œuvre.' },
  { id: 'b', title: 'Panels', text: 'A café, too.' },
  { id: 'c', title: 'ページ', text: 'バージョン' },
];
const LINES = [
  { keys: ['Ctrl', 'Z'], does: 'Undo' },
  { keys: ['Space'], does: 'Shuffle' },
];

const found = (sought: string) => {
  const { topics, lines } = searchHelp(sought, TOPICS, LINES);
  return [...topics.map(({ id }) => id), ...lines.map(({ does }) => does)].join(' ');
};

it('finds all where nothing is asked for', () => expect(found('  ')).toBe('a b c Undo Shuffle'));

it('looks past case, accents and ligatures, and finds what has all words, titles first', () => {
  expect(found('CAFE')).toBe('a b');
  expect(found('groesse')).toBe('');
  expect(found('GROSSE oeuvre')).toBe('a');
  expect(found('cafe too')).toBe('b');
  expect(found('panels zebra')).toBe('');
});

it('takes words by their beginning where any begin so', () => {
  const topics = [
    { id: 'lock', title: 'Locks', text: '' },
    { id: 'block', title: 'Blocks', text: '' },
    { id: 'speech', title: 'Sprechblase', text: '' },
  ];
  const ids = (sought: string) => searchHelp(sought, topics, []).topics.map(({ id }) => id);
  expect([ids('lock'), ids('block'), ids('blase')]).toEqual([['lock'], ['block'], ['speech']]);
});

it('finds keys by what they do and by their names', () => {
  expect(found('shuf')).toBe('Shuffle');
  expect(found('ctrl')).toBe('Undo');
});

it('tells kana apart that differ by their voice alone, and takes wide letters for narrow ones', () => {
  expect(found('ジョン')).toBe('c');
  expect(found('ション')).toBe('');
  expect(found('ｕｎｄｏ')).toBe('Undo');
});

it.each(Object.keys(translations))('in %s every topic has its title and a few sentences', (language) => {
  const topics = topicsIn(language);
  expect(topics.map(({ id }) => id)).toEqual(topicsIn('en').map(({ id }) => id));
  const sentences = (text: string) => text.split(/[.!?。](?=\s|$|[ぁ-んァ-ヶ一-龠「])/).length - 1;
  const wrong = topics.filter(
    ({ title, text }) => title === '' || /undefined|=>/.test(text) || sentences(text) < 2 || sentences(text) > 5,
  );
  expect(wrong).toEqual([]);
});

it('finds topics in the language of the app, and names controls in it', () => {
  const { topics } = searchHelp('melanger', topicsIn('fr'), []);
  expect(topics[0].id).toBe('shuffle');
  expect(topics[0].text).toContain(inLanguage('fr').shuffle);
});
