/** Every language has all messages of English, with the same arguments. */

import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { blocks } from '../engine/types-written.ts';
import { catalogue, compileMessage, languagesOf, leaves } from './compile.js';
import { compose } from './compose.ts';
import { LANGUAGES, localeOf, pickLanguage } from './language.ts';
import { inLanguage, translations } from './testing.ts';
import type { VerdictReason } from '../engine/types.ts';

/** Incomplete languages. Their missing texts appear in English (`docs/guide/translating.md`). */
const PARTIAL: readonly string[] = [];

const english = catalogue('messages', 'en');
const codes = languagesOf('messages');
const others = codes.filter((code) => code !== 'en');

/** @returns all messages of a language by path */
const messagesOf = (code: string) =>
  new Map(['messages', 'help'].flatMap((kind) => leaves(catalogue(kind, code), `${kind}.`)));

const source = messagesOf('en');

/** @returns arguments with their types, except counts: a plural form may omit its number */
function argumentsOf(text: string, code: string): string[] {
  const { given } = compileMessage(text, code);
  return [...given].map(([name, type]) => `${name}: ${type}`).filter((given) => !counts(text, given.split(':')[0]));
}

/** @returns the words of a message, without the syntax of its arguments */
const wordsOf = (text: string) =>
  text.replaceAll(/\{\w+, (?:plural|select),|\{\w+[^{}]*\}|\b(?:one|other)\b/g, ' ').match(/\p{Ll}{2,}/gu) ?? [];

const counts = (text: string, name: string) => text.includes(`{${name}, plural,`);

const styles = readAll('../../styles/');
const layouts = readAll('../../layouts/');
const families = [...styles.flatMap(({ tags }) => tags), ...layouts.map(({ family }) => family)];
const choices = blocks.flatMap(({ params }) => params.flatMap(({ choices }) => choices ?? []));
const asName = inLanguage('en');

/** The names of the core and of the data files: the source of `names/`. */
const NAMES = {
  families: Object.fromEntries([...new Set<string>(families)].map((id) => [id, asName.familyName(id)])),
  choices: Object.fromEntries(
    [...new Set(choices)]
      .filter((id) => !source.has(`messages.choices.${id}`))
      .map((id) => [id, asName.choiceName(id)]),
  ),
  blockNames: Object.fromEntries(blocks.map((block) => [block.id, asName.blockName(block)])),
  blockHelp: Object.fromEntries(blocks.map(({ id, help }) => [id, help])),
  parameters: Object.fromEntries(
    blocks.map(({ id, params }) => [
      id,
      Object.fromEntries(params.map((param) => [param.id, { name: param.label, help: param.help ?? '' }])),
    ]),
  ),
  layouts: Object.fromEntries(layouts.map(({ id, name }) => [id, name])),
  styles: Object.fromEntries(styles.map(({ id, name }) => [id, name])),
  // The core's own messages have details; these are general, for translators.
  reasons: catalogue('names', 'en').reasons as Record<string, string>,
};

it('there is a catalogue for every language', () => {
  expect([...codes].sort()).toEqual(Object.keys(LANGUAGES).sort());
  expect(['help', 'names'].map((kind) => languagesOf(kind).sort())).toEqual([[...codes].sort(), [...codes].sort()]);
  expect(Object.keys(translations).sort()).toEqual([...codes].sort());
});

it('the English names are those of the core and the data files; BLESS=1 writes them', () => {
  const file = new URL('./names/en.json', import.meta.url);
  if (process.env.BLESS === '1') writeFileSync(file, `${JSON.stringify(NAMES, null, 2)}\n`);
  expect(JSON.parse(readFileSync(file, 'utf8'))).toEqual(NAMES);
});

it('controls of blocks have plain names in English; technical terms are only in the brackets of a block name', () => {
  const texts = choices.map((id) => asName.choiceName(id));
  const named = leaves({ help: NAMES.blockHelp, parameters: NAMES.parameters }).map(([, text]) => text);
  expect([...texts, ...named].filter((text) => /\b(bypass|channels?|knee|luma|percentile)\b/i.test(text))).toEqual([]);
});

it('an acronym among the choices of a block stays in capitals', () => {
  expect(['en', 'de', 'fr'].map((code) => inLanguage(code).choiceName('cmyk'))).toEqual(['CMYK', 'CMYK', 'CMJN']);
});

describe.each(codes)('the messages in %s', (code) => {
  it('compile', () => {
    const wrong = [...messagesOf(code)].filter(([, text]) => {
      try {
        compileMessage(text, code);
        return false;
      } catch {
        return true;
      }
    });
    expect(wrong).toEqual([]);
  });
});

describe.each(others)('the messages in %s', (code) => {
  const there = messagesOf(code);

  it.skipIf(PARTIAL.includes(code))('have all keys of English', () => {
    expect([...source.keys()].filter((key) => !there.has(key))).toEqual([]);
  });

  it('have no other keys', () => {
    expect([...there.keys()].filter((key) => !source.has(key))).toEqual([]);
  });

  it('have the arguments of English', () => {
    const wrong = [...there].filter(([key, text]) => {
      const original = source.get(key) ?? '';
      const counted = (given: string) => counts(original, given.split(':')[0]) || counts(text, given.split(':')[0]);
      const names = (from: string, language: string) => argumentsOf(from, language).filter((name) => !counted(name));
      return names(text, code).sort().join() !== names(original, 'en').sort().join();
    });
    // Japanese has one form, so that it needs the number in figures.
    expect(wrong.filter(([key]) => !(code === 'ja' && key.startsWith('messages.things.')))).toEqual([]);
  });

  it('are no sentences of English', () => {
    const said = new Set([...source.values()].filter((text) => wordsOf(text).length > 2));
    expect(said.size).toBeGreaterThan(100);
    expect([...there].filter(([, text]) => said.has(text))).toEqual([]);
  });

  it('have names for filters, styles and layouts; what is missing stays English, and is listed', () => {
    const keys = new Set(leaves(NAMES).map(([key]) => key));
    const named = new Set(leaves(catalogue('names', code)).map(([key]) => key));
    const missing = [...keys].filter((key) => !named.has(key));
    if (missing.length > 0) console.warn(`${LANGUAGES[code as keyof typeof LANGUAGES]} has no name for`, missing);
    expect([...named].filter((key) => !keys.has(key))).toEqual([]);
  });

  it('tell two styles from each other, two layouts of a family, and two blocks', () => {
    const twice = (list: string[]) => list.filter((name, at) => list.indexOf(name) !== at);
    const family = (id: string) => id.split('-')[0];
    const { styles, layouts, blockNames } = catalogue('names', code) as Record<string, Record<string, string>>;
    expect([
      ...twice(Object.values(styles)),
      ...twice(Object.values(blockNames)),
      ...twice(Object.entries(layouts).map(([id, name]) => `${family(id)}: ${name}`)),
    ]).toEqual([]);
  });
});

it('texts are set by the rules of their language', () => {
  const written = (code: string) =>
    ['messages', 'names'].flatMap((kind) =>
      leaves(catalogue(kind, code)).map(([, text]) => text.replaceAll(/, number, ::group-off/g, '')),
    );
  // A line never begins with a punctuation mark, so the space before it does not break.
  expect(written('fr').filter((text) => / [:;!?»]/.test(text))).toEqual([]);
  // Japanese punctuation is full-width.
  expect(
    written('ja').filter((text) => /[ぁ-んァ-ヶ一-龠][,.:;!?()]/.test(text.replaceAll(/\{\w+, [\w ,:-]+/g, '{'))),
  ).toEqual([]);
});

it('blocks have a plain name first, then the term of the field in brackets', () => {
  const plain = new Set<string>(blocks.filter((block) => !block.plain).map(({ id }) => id));
  for (const code of codes) {
    const { blockNames } = catalogue('names', code) as Record<string, Record<string, string>>;
    const told = Object.entries(blockNames).filter(([id]) => !plain.has(id));
    expect(told.length).toBeGreaterThan(PARTIAL.includes(code) ? -1 : 15);
    expect(
      told.filter(([, name]) => !/^[^()（）]+( \([^()]+\)|（[^（）]+）)$/.test(name)).map(([id]) => id),
      code,
    ).toEqual([]);
  }
  const strings = inLanguage('en');
  for (const block of blocks) expect(strings.blockHelp(block)).toBe(block.help);
});

it('long words break at syllables in narrow tiles, and nowhere else', () => {
  const strings = inLanguage('de');
  const style = { id: 'clear-line', name: 'Adventure Album' };
  expect([strings.styleTile(style), strings.styleTitle(style)]).toEqual(['Abenteuer\u00adalbum', 'Abenteueralbum']);
  // Words that are wider than a tile at its smallest.
  const { styles, layouts } = catalogue('names', 'de') as Record<string, Record<string, string>>;
  const long = Object.values({ ...styles, ...layouts }).filter((name) => /[^\s\u00ad-]{13}/.test(name));
  expect(long).toEqual([]);
});

it('what a language has no name for is called as in English', () => {
  const strings = compose('de', { ...translations.de, names: undefined });
  expect(strings.styleTitle({ id: 'new', name: 'New Style' })).toBe('New Style');
  expect(strings.layoutTitle({ id: 'new-3', name: 'New layout' })).toBe('New layout');
  expect(strings.familyName('new_kind')).toBe('New kind');
  expect(strings.blockName({ id: 'new', label: 'New Block', help: '' })).toBe('New Block');
  expect(strings.parameterHelp('new', { id: 'x', label: 'X', help: 'What it does.' })).toBe('What it does.');
});

it('copies are numbered', () => {
  const named = (code: string, name: string) => inLanguage(code).nameOfCopy(name);
  expect(['Ink', 'Ink copy', 'Ink copy 2', 'Ink copy 9'].map((name) => named('en', name))).toEqual([
    'Ink copy',
    'Ink copy 2',
    'Ink copy 3',
    'Ink copy 10',
  ]);
  expect(['a(b', 'a(bのコピー', 'a(bのコピー2'].map((name) => named('ja', name))).toEqual([
    'a(bのコピー',
    'a(bのコピー2',
    'a(bのコピー3',
  ]);
});

it('many names are counted, and sentences are joined as the language joins them', () => {
  const names = ['a', 'b', 'c', 'd'];
  const some = (code: string) => [0, 1, 2, 3, 4].map((n) => inLanguage(code).someNames(names.slice(0, n)));
  expect(some('en')).toEqual(['', 'a', 'a, b', 'a, b, c', 'a, b, c and 1 more']);
  expect(some('ja')).toEqual(['', 'a', 'a、b', 'a、b、c', 'a、b、cほか1個']);
  const joined = (code: string) => inLanguage(code).sentences(['A.', 'B.', 'C.']);
  expect([joined('en'), joined('ja'), inLanguage('en').sentences([])]).toEqual(['A. B. C.', 'A.B.C.', '']);
});

it('no message has the name of a function of the app', () => {
  const strings = compose('en', { messages: () => ({ verdicts: {}, choices: {} }) as never });
  const names = Object.keys(strings).filter((name) => !['verdicts', 'choices'].includes(name));
  expect(names.length).toBeGreaterThan(15);
  expect(names.filter((name) => Object.hasOwn(english, name))).toEqual([]);
});

it('the person chooses the language, then the browser', () => {
  expect(pickLanguage(null, ['en-US', 'es'])).toBe('en');
  expect(pickLanguage(null, ['qaa', 'es-MX', 'en'])).toBe('es');
  expect(pickLanguage(null, ['pt-BR'])).toBe('pt');
  expect(pickLanguage('en', ['es'])).toBe('en');
  expect(pickLanguage('xx', ['qaa'])).toBe('en');
});

it('numbers are written as where the person lives', () => {
  expect(localeOf('es', ['de', 'es-MX', 'es'])).toBe('es-MX');
  expect(localeOf('de', ['fr'])).toBe('de');
  const written = (locale: string) => {
    const { decimal, percent, fileSize, clock } = compose('en', translations.en, locale);
    return [decimal(1234.5, 1), decimal(0.03), percent(0.125, 1), fileSize(2_340_000), clock(62.5)]
      .map((text) => text.replaceAll(/\s/g, ' '))
      .join(' | ');
  };
  expect(written('en')).toBe('1,234.5 | 0.03 | 12.5% | 2.3 MB | 1:02.5');
  expect(written('de')).toBe('1.234,5 | 0,03 | 12,5 % | 2,3 MB | 1:02,5');
  expect(written('es-MX')).toBe('1,234.5 | 0.03 | 12.5% | 2.3 MB | 1:02.5');
  expect(written('fr')).toBe('1 234,5 | 0,03 | 12,5 % | 2,3 Mo | 1:02,5');
  expect(written('ja')).toBe('1,234.5 | 0.03 | 12.5% | 2.3 MB | 1:02.5');
});

it('turns the reasons for photos', () => {
  const reasons: VerdictReason[] = [
    { code: 'same-as', name: 'only one like it.jpg' },
    { code: 'sharpest', of: 3 },
    { code: 'open-eyes', of: 3 },
    { code: 'only' },
    { code: 'blurred' },
    { code: 'frame' },
  ];
  expect(reasons.map(inLanguage('en').verdict)).toEqual([
    'same as only one like it.jpg',
    'sharpest of 3',
    'open eyes, best of 3',
    'only one like it',
    'blurred',
    'another frame of the video',
  ]);
  expect(reasons.map(inLanguage('es').verdict)).toEqual([
    'igual que only one like it.jpg',
    'la más nítida de 3',
    'ojos abiertos, la mejor de 3',
    'la única así',
    'desenfocada',
    'otro fotograma del vídeo',
  ]);
});

it('counts what is seen', () => {
  const things = [
    { label: 'person', count: 2 },
    { label: 'elephant', count: 1 },
    { label: 'knife', count: 13 },
  ];
  const seen = (code: string) => inLanguage(code).seen(things);
  expect(seen('en')).toBe('two people, an elephant, and 13 knives');
  expect(seen('de')).toBe('zwei Personen, ein Elefant und 13 Messer');
  expect(seen('es')).toBe('dos personas, un elefante y 13 cuchillos');
  expect(seen('fr')).toBe('deux personnes, un éléphant et 13 couteaux');
  expect(seen('pt')).toBe('duas pessoas, um elefante e 13 facas');
  expect(seen('ja')).toBe('2人、象1頭、ナイフ13本');
  expect(inLanguage('en').seen([])).toBe('');
});

/** @returns the data files in it */
function readAll(folder: string): any[] {
  const url = new URL(folder, import.meta.url);
  return readdirSync(url)
    .filter((name) => name.endsWith('.json'))
    .map((name) => JSON.parse(readFileSync(new URL(name, url), 'utf8')));
}
