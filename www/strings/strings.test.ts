/** Every language has all strings of English, in the same form. */

import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { core } from '../engine/testing-core.ts';
import { compose } from './compose.ts';
import * as english from './en/index.ts';
import { LANGUAGES, localeOf, pickLanguage } from './language.ts';
import { filled } from './partial.ts';
import { inLanguage, translations } from './testing.ts';

/** Incomplete languages. Their missing texts appear in English (`docs/guide/translating.md`). */
const PARTIAL: readonly string[] = [];

const others = Object.entries(translations).filter(([code]) => code !== 'en');

/** @returns `function of 2`, `array of 3`, `object`, `string` */
function kind(value: unknown): string {
  if (typeof value === 'function') return `function of ${value.length}`;
  return Array.isArray(value) ? `array of ${value.length}` : typeof value;
}

/** @returns every key below, with the type of its value */
function shape(value: any, path: string = ''): [string, string][] {
  const below = value !== null && typeof value === 'object' ? Object.entries(value) : [];
  return [[path, kind(value)], ...below.flatMap(([key, inner]) => shape(inner, `${path}.${key}`))];
}

/** @returns every text below */
function texts(value: unknown): string[] {
  if (typeof value === 'string') return [value];
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(texts) : [];
}

/** Ids that languages name, by area of `Names`. */
const named = {
  styles: readAll('../../styles/').map(({ id }) => id),
  layouts: readAll('../../layouts/').map(({ id }) => id),
  families: [
    ...readAll('../../styles/').flatMap(({ tags }) => tags),
    ...readAll('../../layouts/').map(({ family }) => family),
  ],
  blocks: core.blocks().map(({ id }) => id),
  parameters: core.blocks().flatMap(({ id, params }) => params.map((param) => `${id}.${param.id}`)),
  choices: core.blocks().flatMap(({ params }) => params.flatMap(({ choices }) => choices ?? [])),
} satisfies Record<string, string[]>;

it('there is a folder for every language', () => {
  expect(Object.keys(translations).sort()).toEqual(Object.keys(LANGUAGES).sort());
});

describe.each(others)('the words in %s', (code, { words, names }) => {
  it.skipIf(PARTIAL.includes(code))('are as many as the English ones, and of the same kinds', () => {
    const there = new Map(shape(words));
    expect(shape(english.words).filter(([path, what]) => there.get(path) !== what)).toEqual([]);
  });

  it('have no key that English lacks, but for reasons by code', () => {
    const there = new Map(shape(english.words));
    expect(shape(words).filter(([path]) => !there.has(path) && !/^\.(reasons|projectReasons)\./.test(path))).toEqual(
      [],
    );
  });

  it('are nothing that English is not, but less where a language is partial', () => {
    const there = new Map(shape(words));
    expect(shape(english.words).filter(([path, what]) => (there.get(path) ?? what) !== what)).toEqual([]);
  });

  it('are no sentences of English', () => {
    const said = new Set(texts(english.words).filter((text) => text.split(' ').length > 2));
    expect(said.size).toBeGreaterThan(100);
    expect(texts(words).filter((text) => said.has(text))).toEqual([]);
  });

  it('are in files that import nothing from outside their folder, for which the page would wait in a circle', () => {
    const folder = new URL(`./${code}/`, import.meta.url);
    const imports = readdirSync(folder).flatMap((name) => [
      ...readFileSync(new URL(name, folder), 'utf8').matchAll(/^import (?!type ).* from '(.*)'/gm),
    ]);
    expect(imports.length).toBeGreaterThan(PARTIAL.includes(code) ? 0 : 10);
    expect(imports.map(([, from]) => from).filter((from) => !from.startsWith('./'))).toEqual([]);
  });

  it('name what filters, styles and layouts bring along; what is missing stays English, and is listed', () => {
    const missing = Object.entries(named).flatMap(([area, ids]) =>
      [...new Set(ids)].filter((id) => !(id in names[area as keyof typeof named])).map((id) => `${area}.${id}`),
    );
    if (missing.length > 0) console.warn(`${LANGUAGES[code as keyof typeof LANGUAGES]} has no name for`, missing);
    const gone = Object.entries(named).flatMap(([area, ids]) =>
      Object.keys(names[area as keyof typeof named])
        .filter((id) => !ids.includes(id))
        .map((id) => `${area}.${id}`),
    );
    expect(gone).toEqual([]);
  });

  it('tell two styles from each other, two layouts of a family, and two blocks', () => {
    const twice = (list: string[]) => list.filter((name, at) => list.indexOf(name) !== at);
    const family = (id: string) => id.split('-')[0];
    expect([
      ...twice(Object.values(names.styles)),
      ...twice(Object.values(names.blocks).map(([name]) => name)),
      ...twice(Object.entries(names.layouts).map(([id, name]) => `${family(id)}: ${name}`)),
    ]).toEqual([]);
  });
});

it('texts are set by the rules of their language', () => {
  const written = (code: string) =>
    readdirSync(new URL(`./${code}/`, import.meta.url)).map((name) =>
      readFileSync(new URL(`./${code}/${name}`, import.meta.url), 'utf8'),
    );
  // A line never begins with a punctuation mark, so the space before it does not break. Code contains other marks.
  const loose = written('fr').flatMap((text) => text.match(/[a-zà-ÿ)}] [:;!?»](?= [a-zà-ÿ$«]|['`])/g) ?? []);
  expect(loose.filter((found) => !/[)}] [:?]/.test(found))).toEqual([]);
  // Japanese punctuation is full-width.
  expect(written('ja').flatMap((text) => text.match(/[ぁ-んァ-ヶ一-龠][,.:;!?()]/g) ?? [])).toEqual([]);
});

it('blocks have a plain name first, then the term of the field in brackets', () => {
  const plain = new Set(['brightness', 'paper']);
  for (const [code, { names }] of Object.entries(translations)) {
    const told = Object.entries(names.blocks).filter(([id]) => !plain.has(id));
    expect(told.length).toBeGreaterThan(PARTIAL.includes(code) ? -1 : 15);
    expect(
      told.filter(([, [name]]) => !/^[^()（）]+( \([^()]+\)|（[^（）]+）)$/.test(name)).map(([id]) => id),
      code,
    ).toEqual([]);
  }
  const strings = compose('en', translations.en);
  for (const block of core.blocks()) {
    const name = strings.blockName(block);
    expect(name === block.label || name.endsWith(` (${block.label})`), name).toBe(true);
    expect(strings.blockHelp(block)).toBe(block.help);
  }
});

it('what a language has no name for is called as in English', () => {
  const none = { ...english, names: { ...english.names, styles: {} } };
  const strings = compose('de', none);
  expect(strings.styleTitle({ id: 'new', name: 'New Style' })).toBe('New Style');
  expect(strings.layoutTitle({ id: 'new-3', name: 'New layout' })).toBe('New layout');
  expect(strings.familyName('new_kind')).toBe('New kind');
  expect(strings.blockName({ id: 'new', label: 'New Block', help: '' })).toBe('New Block');
  expect(strings.parameterHelp('new', { id: 'x', label: 'X', help: 'What it does.' })).toBe('What it does.');
});

it('what a language has no words for is said in English', () => {
  const whole = { title: 'Title', many: (n: number) => `${n} things`, group: { a: 'A', b: 'B' }, list: ['1', '2'] };
  const part = filled({ many: (n: number) => `${n} Dinge`, group: { b: 'Be' }, list: ['eins', 'zwei'] }, whole);
  expect(part.many(3)).toBe('3 Dinge');
  expect({ ...part, many: 0 }).toEqual({ title: 'Title', many: 0, group: { a: 'A', b: 'Be' }, list: ['eins', 'zwei'] });
  expect(whole.group.b).toBe('B');

  const { words, names } = translations.de;
  const half = { shuffle: words.shuffle, book: { add: words.book.add } };
  const strings = compose('de', { names, words: filled(half, english.words) });
  expect([strings.shuffle, strings.book.add]).toEqual([words.shuffle, words.book.add]);
  expect([strings.book.remove, strings.chooseFiles, strings.panelCount(2)]).toEqual([
    english.words.book.remove,
    english.words.chooseFiles,
    '2 panels',
  ]);
  expect(shape(filled({}, english.words))).toEqual(shape(english.words));
});

it('no two areas have a word of the same name', () => {
  const areas = import.meta.glob(['./en/*.ts', '!./en/index.ts', '!./en/names.ts', '!./en/blocks.ts'], {
    eager: true,
  }) as Record<string, Record<string, object>>;
  const words = Object.values(areas)
    .flatMap((area) => Object.values(area))
    .flatMap(Object.keys);
  expect(words.length).toBeGreaterThan(300);
  const strings = compose('en', { ...english, words: {} as typeof english.words });
  const names = [...Object.keys(strings), ...words];
  expect(names.filter((name, at) => names.indexOf(name) !== at)).toEqual([]);
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
    const { decimal, percent, fileSize, clock } = compose(locale, english);
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
  const reasons = ['same as only one like it.jpg', 'sharpest of 3', 'only one like it', 'blurred'];
  expect(reasons.map(inLanguage('en').verdict)).toEqual(reasons);
  expect(reasons.map(inLanguage('es').verdict)).toEqual([
    'igual que only one like it.jpg',
    'la más nítida de 3',
    'la única así',
    'desenfocada',
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
