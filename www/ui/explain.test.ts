import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { inLanguage } from '../strings/testing.ts';
import { detailOf, explain } from './explain.ts';
import { UserError } from './user-error.ts';

const coded = (code: string, message: string) => Object.assign(new Error(message), { code });

/** Codes of bugs, and codes that the app handles without a sentence for the user. */
const INTERNAL = new Set([
  'buffer-size',
  'cancelled',
  'conflict',
  'disposed',
  'empty-project',
  'invalid-bank',
  'invalid-document',
  'missing-page',
  'sound-large',
  'sound-long',
  'sound-none',
  'sound-undecodable',
]);

const sourceOf = (path: string) => readFileSync(new URL(path, import.meta.url), 'utf8');

/** @returns the codes of the core, which `cargo xtask bless types` writes */
function coreCodes(): string[] {
  const [, union] = /export type ErrorCode =([^;]+);/.exec(sourceOf('../engine/types.ts')) ?? [];
  return [...(union ?? '').matchAll(/'([\w-]+)'/g)].map(([, code]) => code);
}

/** @returns the codes of errors that the front end creates, in all of its files */
function appCodes(): string[] {
  const root = new URL('../', import.meta.url);
  const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter(
    (path) => /^[a-z]+\/.*\.tsx?$/.test(path) && !/node_modules|^strings\/|^pkg|test(?:ing)?\.tsx?$/.test(path),
  );
  expect(files.length).toBeGreaterThan(300);
  return files.flatMap((path) =>
    [
      ...sourceOf(`../${path}`).matchAll(
        /failure\(\s*'([\w-]+)'|failed\('([\w-]+)'|\bcode: '([\w-]+)' \}\)|'([a-z]+-missing)'/g,
      ),
    ].map((found) => found.slice(1).find(Boolean) ?? ''),
  );
}

test('an error with a known code has a translated reason', () => {
  expect(explain(coded('not-text', 'invalid utf-8'))).toMatch(/^it is not a text file/);
  expect(explain(coded('unknown-format', 'this is not an image'))).toMatch(/^the file is damaged, or not an image/);
  expect(explain(coded('newer-project', 'version: 9'))).toMatch(/^it was saved by a newer version/);
  expect(explain(coded('odd', 'x'), { reasons: { odd: 'it is odd' } })).toBe('it is odd');
});

test('English messages of the core and of browsers are shown in English only', () => {
  const errors = [
    coded('unheard-of', 'plain'),
    new DOMException('Write denied', 'NotAllowedError'),
    new Error('Of a library'),
  ];
  expect(errors.map((error) => explain(error, { english: true }))).toEqual([
    'plain',
    'an internal error occurred: Write denied',
    'Of a library',
  ]);
  expect(errors.map((error) => explain(error, { english: false }))).toEqual([
    'an internal error occurred: unheard-of',
    'an internal error occurred: NotAllowedError',
    'an internal error occurred: Error',
  ]);
  expect(explain(new UserError('Schon übersetzt.'), { english: false })).toBe('Schon übersetzt.');
});

test('the detail of an error is its English message in English only', () => {
  const errors = [coded('damaged-project', 'page: is missing'), new TypeError('x is undefined'), null];
  expect(errors.map((error) => detailOf(error, true))).toEqual(['page: is missing', 'x is undefined', '']);
  expect(errors.map((error) => detailOf(error, false))).toEqual(['damaged-project', 'TypeError', '']);
});

test('every error code of the core and of the app has a sentence in every language, or is a bug', () => {
  const codes = [...new Set([...coreCodes(), ...appCodes()])];
  expect(codes.length).toBeGreaterThan(60);
  for (const language of ['de', 'es', 'fr', 'ja', 'pt']) {
    const strings = inLanguage(language);
    const groups = [strings.reasons, strings.projectReasons, strings.imitationReasons, strings.reasonsOf];
    const hasSentence = (code: string) =>
      groups.some((group) => Object.hasOwn(group, code)) || strings.coreReason(code) !== undefined;
    expect(codes.filter((code) => !hasSentence(code) && !INTERNAL.has(code)).sort(), language).toEqual([]);
    expect([...INTERNAL].filter((code) => !codes.includes(code) || hasSentence(code))).toEqual([]);
  }
});

test('no language shows a message of the core', () => {
  for (const code of [...coreCodes(), ...appCodes()]) {
    const said = explain(coded(code, 'SECRET'), { english: false });
    expect(said.includes('SECRET'), code).toBe(['film-container', 'film-codec', 'damaged-photo'].includes(code));
  }
});
