/** A language says all that English says, in the same form. */

import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { english } from './en/index.ts';
import { spanish } from './es/index.ts';
import { everyStrings } from './every.ts';
import { pickLanguage } from './language.ts';

/** @returns `function of 2`, `array of 3`, `object`, `string` */
function kind(value: unknown): string {
  if (typeof value === 'function') return `function of ${value.length}`;
  return Array.isArray(value) ? `array of ${value.length}` : typeof value;
}

/** @returns every key below, with the kind of what it holds */
function shape(value: any, path: string = ''): [string, string][] {
  const below = value !== null && typeof value === 'object' ? Object.entries(value) : [];
  return [[path, kind(value)], ...below.flatMap(([key, inner]) => shape(inner, `${path}.${key}`))];
}

describe.each([['es', spanish]])('the words in %s', (code, language) => {
  it('are as many as the English ones, and of the same kinds', () => {
    const there = new Map(shape(language));
    expect(shape(english).filter(([path, what]) => there.get(path) !== what)).toEqual([]);
  });

  it('have no key that English lacks, but for reasons by code', () => {
    const there = new Map(shape(english));
    expect(shape(language).filter(([path]) => !there.has(path) && !/^\.(reasons|projectReasons)\./.test(path))).toEqual(
      [],
    );
  });

  it('are in files that import nothing from outside their folder, for which the page would wait in a circle', () => {
    const folder = new URL(`./${code}/`, import.meta.url);
    const imports = readdirSync(folder).flatMap((name) => [
      ...readFileSync(new URL(name, folder), 'utf8').matchAll(/^import (?!type ).* from '(.*)'/gm),
    ]);
    expect(imports.length).toBeGreaterThan(10);
    expect(imports.map(([, from]) => from).filter((from) => !from.startsWith('./'))).toEqual([]);
  });

  it('name every designed style, layout, family and tag', () => {
    const styles = readAll('../../styles/');
    const layouts = readAll('../../layouts/');
    expect(styles.filter(({ id }) => language.styleTitle({ id, name: 'none' }) === 'none').map(({ id }) => id)).toEqual(
      [],
    );
    expect(
      layouts.filter(({ id }) => language.layoutTitle({ id, name: 'none' }) === 'none').map(({ id }) => id),
    ).toEqual([]);
    const families = new Set([...styles.flatMap(({ tags }) => tags), ...layouts.map(({ family }) => family)]);
    expect(
      [...families].filter(
        (id) => language.familyName(id) === english.familyName(id) && !['manga', 'pop'].includes(id),
      ),
    ).toEqual([]);
  });
});

it('no two areas have a word of the same name', () => {
  const areas = import.meta.glob(['./en/*.ts', '!./en/index.ts'], { eager: true }) as Record<
    string,
    Record<string, object>
  >;
  const names = [everyStrings, ...Object.values(areas).flatMap((area) => Object.values(area))].flatMap(Object.keys);
  expect(names.length).toBeGreaterThan(300);
  expect(names.filter((name, at) => names.indexOf(name) !== at)).toEqual([]);
});

it('the person chooses the language, then the browser', () => {
  expect(pickLanguage(null, ['en-US', 'es'])).toBe('en');
  expect(pickLanguage(null, ['fr', 'es-MX', 'en'])).toBe('es');
  expect(pickLanguage('en', ['es'])).toBe('en');
  expect(pickLanguage('xx', ['fr'])).toBe('en');
});

it('turns the reasons for photos', () => {
  const reasons = ['same as only one like it.jpg', 'sharpest of 3', 'only one like it', 'blurred'];
  expect(reasons.map(spanish.verdict)).toEqual([
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
  expect(english.seen(things)).toBe('two people, an elephant, and 13 knives');
  expect(spanish.seen(things)).toBe('dos personas, un elefante y 13 cuchillos');
  expect([english.seen([]), spanish.seen([])]).toEqual(['', '']);
});

/** @returns the data files in it */
function readAll(folder: string): any[] {
  const url = new URL(folder, import.meta.url);
  return readdirSync(url)
    .filter((name) => name.endsWith('.json'))
    .map((name) => JSON.parse(readFileSync(new URL(name, url), 'utf8')));
}
