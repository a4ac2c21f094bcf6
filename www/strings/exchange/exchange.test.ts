/**
 * Exported texts are identical after import. Texts that the importer does not understand are neither changed nor lost.
 */

import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { po } from 'gettext-parser';
import { afterAll, describe, expect, it } from 'vitest';
import { LANGUAGES } from '../language.ts';
import { translations } from '../testing.ts';
import { catalogue, filesIn } from './catalogue.js';
import { exported, imported, pluralForms } from './po.js';
import { readSource, sentenceOf } from './source.js';
import { completeFolder, put } from './write.js';
import type { Files } from './po.js';
import type { Translation } from '../compose.ts';

const all = catalogue();
const others = Object.keys(LANGUAGES).filter((code) => code !== 'en');
const filesOf = (code: string): Files => filesIn(`../${code}/`);

const made: string[] = [];
afterAll(() => {
  for (const folder of made) rmSync(folder, { recursive: true });
});

/** @returns the sentence that a piece of code is */
function sentence(code: string, before: string = '') {
  const source = readSource(`${before}\nexport const a = ${code};`, 'a.ts');
  const node = source.exported.get('a');
  return sentenceOf(source, node.type === 'TSAsExpression' ? node.expression : node);
}

/** A PO file with some changed texts. */
function changed(code: string, change: (context: string, entry: { msgid: string; msgstr: string[] }) => void) {
  const file = po.parse(exported(code, filesOf(code), all).text);
  for (const [context, entries] of Object.entries(file.translations)) {
    for (const entry of Object.values(entries)) if (entry.msgid !== '') change(context, entry);
  }
  return po.compile(file).toString();
}

/** @returns the texts of a PO file, by context */
const msgstrs = (text: string) =>
  new Map(
    Object.entries(po.parse(text).translations).flatMap(([context, entries]) =>
      Object.values(entries).map(({ msgstr }) => [context, msgstr.join('|')] as const),
    ),
  );

/**
 * The results of a function for several arguments, and all other texts. The count 0 is not tested: languages that treat
 * 0 as singular do so in most texts here, not in all.
 */
function said(value: unknown): unknown {
  if (typeof value === 'function') return [1, 2, 7].map((n) => told(value, n));
  if (Array.isArray(value)) return value.map(said);
  if (value !== null && typeof value === 'object') {
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, said(inner)]));
  }
  return value;
}

function told(say: Function, n: number): string {
  const counted = (count: number, [one, many]: readonly string[]) => `${count} ${count === 1 ? one : many}`;
  const named = { label: 'dog', count: n, title: 'T', author: 'A', licence: 'L', names: ['a'], name: 'N' };
  const attempts = [
    [n, n + 1, n, n],
    [['a', 'b'], n, n],
    [named, counted],
    ['x', n, n, 'y'],
    ['x', ['a'], n],
  ];
  return attempts.map((given) => quietly(() => JSON.stringify(say(...given)))).join('|');
}

function quietly(what: () => string): string {
  try {
    return what();
  } catch {
    return 'not of such';
  }
}

describe.each(others)('%s', (code) => {
  it('comes back from its file with every byte as it was', () => {
    const { text } = exported(code, filesOf(code), all);
    const back = imported(text, filesOf, all);
    expect([back.language, back.changed, back.refused]).toEqual([code, 0, []]);
    expect([...back.files]).toEqual([...filesOf(code)]);
  });

  it('is written anew from its file alone, with the same strings', async () => {
    const { text, missing } = exported(code, filesOf(code), all);
    const back = imported(text, () => new Map(), all);
    expect([missing, back.refused]).toEqual([0, []]);
    completeFolder(back.files, all.sources);
    const again = msgstrs(exported(code, back.files, all).text);
    expect([...msgstrs(text)].filter(([context, told]) => again.get(context) !== told)).toEqual([]);

    // As the page would run it.
    const folder = mkdtempSync(join(tmpdir(), 'inkpanel-strings-'));
    made.push(folder);
    mkdirSync(join(folder, code));
    for (const [name, file] of back.files) writeFileSync(join(folder, code, `${name}.ts`), file);
    const anew: Translation = await import(/* @vite-ignore */ join(folder, code, 'index.ts'));
    const byHand = new Set(
      [...all.code, ...exported(code, filesOf(code), all).code].map((context) => context.split('/').slice(2).join('.')),
    );
    const differ = (left: any, right: any, path: string): string[] => {
      if (byHand.has(path) || left === '' || JSON.stringify(left) === JSON.stringify(right)) return [];
      // Reasons by code that English has in the core.
      if (right === undefined) return /^(reasons|projectReasons)\./.test(path) ? [] : [path];
      if (left === null || typeof left !== 'object' || Array.isArray(left)) return [path];
      return Object.keys(left).flatMap((key) => differ(left[key], right[key], path ? `${path}.${key}` : key));
    };
    expect(differ(said(translations[code].words), said(anew.words), '')).toEqual([]);
    expect(differ(said(translations[code].names), said(anew.names), '')).toEqual([]);
  });
});

it('every sentence of English is in the file, or is told to be code', () => {
  const { text } = exported('de', new Map(), all);
  expect(all.messages.length).toBeGreaterThan(1000);
  expect(text.match(/^msgctxt /gm)?.length).toBe(all.messages.length);
  // More of these are more that a translator cannot do without code.
  expect(all.code.length).toBeLessThan(30);
});

it('counted sentences have the forms of the language, and places their names', () => {
  expect(sentence("(n: number) => (n === 1 ? '1 panel' : `${n} panels`)")).toMatchObject({
    one: '1 panel',
    many: '{n} panels',
    count: 'n',
    parameters: '(n: number)',
  });
  const count = 'const count = (n: number, one: string) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);';
  expect(sentence("(left: number) => `Add: ${count(left, 'photo')}`", count)).toMatchObject({
    one: 'Add: 1 photo',
    many: 'Add: {left} photos',
    count: 'left',
  });
  expect(sentence("(n: number) => (n < 2 ? 'une' : `${n}`)")).toMatchObject({ one: 'une', condition: '< 2' });
  expect(sentence('({ title }: { title: string }) => `“${title}”`')).toMatchObject({ many: '“{title}”', count: null });
  expect(sentence('(s: string) => s.toUpperCase()')).toBe(null);
  expect(sentence("(a: boolean) => (a ? 'yes' : 'no')")).toBe(null);
  expect(sentence("(n: number) => (n === 5 ? 'five' : 'other')")).toBe(null);
  expect([pluralForms('ja').forms, pluralForms('de').forms, pluralForms('fr').condition]).toEqual([1, 2, '< 2']);
});

it('a changed sentence changes its line alone', () => {
  const text = changed('de', (context, entry) => {
    if (context === 'board/boardStrings/shuffle') entry.msgstr = ["Misch's \\ neu"];
    if (context === 'board/boardStrings/panel') entry.msgstr = ['{of}: `Panel` ${n}'];
    if (context === 'side/sideStrings/panelCount') entry.msgstr = ['ein Feld', '{n} Felder'];
  });
  const { files, changed: count, refused } = imported(text, filesOf, all);
  expect([count, refused]).toEqual([3, []]);
  const before = filesOf('de');
  const lines = ['board', 'side'].flatMap((area) => {
    const was = before.get(area)?.split('\n') ?? [];
    return (
      files
        .get(area)
        ?.split('\n')
        .filter((line) => !was.includes(line)) ?? []
    );
  });
  expect(lines.map((line) => line.trim())).toEqual([
    'panel: (n: number, of: number) => `${of}: \\`Panel\\` \\$${n}`,',
    "shuffle: 'Misch\\'s \\\\ neu',",
    "panelCount: (n: number) => n === 1 ? 'ein Feld' : `${n} Felder`,",
  ]);
});

it('what is not understood is named, and the files stay as they were', () => {
  const wrong: Record<string, (entry: any) => void> = {
    'board/boardStrings/panel': (entry) => (entry.msgstr = ['Panel {x} von {of}']),
    'board/boardStrings/versionAt': (entry) => (entry.msgstr = ['Version {n}']),
    'board/boardStrings/shuffle': (entry) => (entry.msgid = 'Shuffle all'),
    'book/bookStrings/book/page': (entry) => (entry.msgstr = ['Seite {n} von {of']),
    'book/bookStrings/book/add': (entry) => Object.assign(entry, { msgstr: ['Neu'], comments: { flag: 'fuzzy' } }),
    'side/sideStrings/panelCount': (entry) => (entry.msgstr = ['', '{n} Felder']),
    'start/startStrings/starting': (entry) =>
      Object.assign(entry, { msgctxt: 'start/startStrings/gone', msgstr: ['x'] }),
  };
  const text = changed('de', (context, entry) => wrong[context]?.(entry));
  const { files, changed: count, refused } = imported(text, filesOf, all);
  expect(count).toBe(0);
  expect([...files]).toEqual([...filesOf('de')]);
  const reasons = Object.fromEntries(refused.map((line) => [line.split(': ')[0].split('/').at(-1), line]));
  expect(Object.keys(reasons).sort()).toEqual(['add', 'gone', 'page', 'panel', 'panelCount', 'shuffle', 'versionAt']);
  expect(reasons.panel).toContain('nothing is called {x}: there is {n}, {of}');
  expect(reasons.versionAt).toContain('{of} is lost');
  expect(reasons.page).toContain('stands alone');
  expect(reasons.shuffle).toContain('the English is another now');
});

it('what is left empty stays as it was', () => {
  const text = changed('fr', (_, entry) => (entry.msgstr = entry.msgstr.map(() => '')));
  const { files, changed: count, refused } = imported(text, filesOf, all);
  expect([count, refused, [...files]]).toEqual([0, [], [...filesOf('fr')]]);
});

it('a new language begins with what is translated', () => {
  const text = changed('de', (context, entry) => {
    const kept = [
      'board/boardStrings/shuffle',
      'book/bookStrings/book/page',
      'styles/styles/comic',
      'blocks/blocks/hue/1',
    ];
    if (!kept.includes(context) && !context.startsWith('help/helpStrings/topics/adding'))
      entry.msgstr = entry.msgstr.map(() => '');
  }).replace('"Language: de\\n"', '"Language: nl\\n"');
  const { language, files, refused } = imported(text, () => new Map(), all);
  expect(language).toBe('nl');
  completeFolder(files, all.sources);
  expect([...files.keys()].sort()).toEqual(['blocks', 'board', 'book', 'help', 'index', 'layouts', 'names', 'styles']);
  expect(files.get('index')).toContain('  ...boardStrings,\n  ...bookStrings,\n  ...helpStrings,\n};');
  // The help names controls, and a help comes with its name.
  expect(refused.map((line) => line.replace(/: [a-z]+\/.* has to be/, ': … has to be'))).toEqual([
    'blocks/blocks/hue/1: what comes before it in its list has to be translated first',
    'help/helpStrings/topics/adding/text: … has to be translated first',
  ]);
});

it('a file of no language is refused', () => {
  for (const language of ['', 'en', '../de']) {
    const text = exported('de', new Map(), all).text.replace('"Language: de\\n"', `"Language: ${language}\\n"`);
    expect(() => imported(text, filesOf, all)).toThrow('the header Language says');
  }
});

it('a sentence is put where there is nothing yet', () => {
  const files: Files = new Map([['book', 'export const bookStrings = { book: { add: "x" } };\n']]);
  const message = all.messages.find(({ context }) => context === 'book/bookStrings/book/name');
  expect(message && put(files, message, "'Seiten'", all.sources)).toBe('');
  expect(files.get('book')).toBe('export const bookStrings = { book: { add: "x", name: \'Seiten\',} };\n');
});
