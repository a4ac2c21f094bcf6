/** Tests of the message compiler: accepted messages, and results of the compiled functions. */

import { describe, expect, it } from 'vitest';
import { categoriesOf, compileMessage, fields } from './compile.js';
import { formatsIn } from './formats.ts';
import { numbersIn } from './numbers.ts';

/** @returns the text of a message with these arguments */
function said(text: string, given: Record<string, string | number> = {}, language = 'en'): string {
  const { code } = compileMessage(text, language);
  const formats = formatsIn(language, numbersIn(language));
  return new Function('a', ...Object.keys(formats), `return ${code}`)(given, ...Object.values(formats));
}

describe('a message', () => {
  it('keeps its text with all signs', () => {
    expect(said('`a` $ \\ it’s 100 % <b>')).toBe('`a` $ \\ it’s 100 % <b>');
    expect(said("'{'x'}' ''")).toBe("{x} '");
  });

  it('takes named arguments, and formats numbers as the locale does', () => {
    expect(said('{a} and {b, number}', { a: 'x', b: 1234.5 })).toBe('x and 1,234.5');
    expect(said('{b, number}', { b: 1234.5 }, 'de')).toBe('1.234,5');
    expect(said('{dpi, number, ::group-off} dpi', { dpi: 1200 })).toBe('1200 dpi');
  });

  it('chooses the plural form of the language', () => {
    const photos = '{n, plural, =0 {no photos} one {# photo} other {# photos}}';
    expect([0, 1, 2, 1234].map((n) => said(photos, { n }))).toEqual([
      'no photos',
      '1 photo',
      '2 photos',
      '1,234 photos',
    ]);
    const french = '{n, plural, one {# case} other {# cases}}';
    expect([0, 1, 2].map((n) => said(french, { n }, 'fr'))).toEqual(['0 case', '1 case', '2 cases']);
    const polish = '{n, plural, one {# plik} few {# pliki} many {# plików} other {# pliku}}';
    expect([1, 2, 5, 22].map((n) => said(polish, { n }, 'pl'))).toEqual(['1 plik', '2 pliki', '5 plików', '22 pliki']);
  });

  it('chooses by a word', () => {
    const text = '{kind, select, photo {a photo} other {a file}}';
    expect(['photo', 'valueOf'].map((kind) => said(text, { kind }))).toEqual(['a photo', 'a file']);
  });

  it('has the types of its arguments', () => {
    const { given } = compileMessage('{a}: {n, plural, one {# of {all, number}} other {#}}', 'en');
    expect(Object.fromEntries(given)).toEqual({ a: 'string', n: 'number', all: 'number' });
  });
});

it.each([
  ['{n, plural, one {#}}', 'en'],
  ['{n, plural, other {#}}', 'en'],
  ['{n, plural, one {#} few {#} other {#}}', 'pl'],
  ['{n, plural, offset:1 one {#} other {#}}', 'en'],
  ['{n, selectordinal, one {#st} other {#th}}', 'en'],
  ['{kind, select, photo {a photo}}', 'en'],
  ['{n, number, percent}', 'en'],
  ['{at, date}', 'en'],
  ['{a} {a, number}', 'en'],
  ['{a', 'en'],
])('%s is refused in %s', (text, language) => {
  expect(() => compileMessage(text, language)).toThrow();
});

it('the plural categories are those of the numbers that the app counts', () => {
  const all = ['en', 'fr', 'ja', 'pl'].map((language) => [...categoriesOf(language)].sort().join(' '));
  expect(all).toEqual(['one other', 'one other', 'other', 'few many one other']);
});

describe('the messages of a language', () => {
  const source = {
    title: 'Title',
    many: '{n, plural, one {# thing} other {# things}}',
    group: { a: 'A', named: '{name}' },
  };
  const compiled = (texts: Parameters<typeof fields>[1], language = 'de') => {
    const formats = formatsIn(language, numbersIn(language));
    const code = `return {${fields(language, texts, source)}}`;
    return new Function(...Object.keys(formats), code)(...Object.values(formats));
  };

  it('replace those of the source, which remain where a text is missing', () => {
    const part = compiled({ many: '{n, plural, one {# Ding} other {# Dinge}}', group: { a: 'Ah' } });
    expect([part.title, part.many({ n: 2 }), part.group.a, part.group.named({ name: 'x' })]).toEqual([
      'Title',
      '2 Dinge',
      'Ah',
      'x',
    ]);
    expect(compiled({}).many({ n: 1 })).toBe('1 thing');
    expect(compiled({ many: 'Viele' }).many({ n: 1 })).toBe('Viele');
  });

  it.each([
    [{ other: 'X' }, 'other is not a key of the source'],
    [{ group: 'X' }, 'group is a group in one language only'],
    [{ title: { a: 'X' } }, 'title is a group in one language only'],
    [{ title: '{name}' }, 'title: the source has no { name: string }'],
    [{ many: '{n}' }, 'many: the source has no { n: string }'],
    [{ group: { named: '{nmae}' } }, 'group.named: the source has no { nmae: string }'],
    [{ many: '{n, plural, other {#}}' }, 'many: {n} has no plural form one'],
  ])('%j is refused', (texts, why) => {
    expect(() => compiled(texts as Parameters<typeof fields>[1])).toThrow(`de: ${why}`);
  });
});
