import { expect, test } from 'vitest';
import { explain } from './explain.ts';

const coded = (code: string, message: string) => Object.assign(new Error(message), { code });

test('an error with a known code has a translated reason', () => {
  expect(explain(coded('not-text', 'invalid utf-8'))).toMatch(/^it is not a text file/);
  expect(explain(coded('newer-project', 'version: 9'))).toMatch(/^it was saved by a newer version/);
  expect(explain(coded('odd', 'x'), { reasons: { odd: 'it is odd' } })).toBe('it is odd');
});

test('English messages of the core and of browsers are shown in English only', () => {
  const errors = [coded('unheard-of', 'plain'), new DOMException('Write denied', 'NotAllowedError')];
  expect(errors.map((error) => explain(error, { english: true }))).toEqual([
    'plain',
    'an internal error occurred: Write denied',
  ]);
  expect(errors.map((error) => explain(error, { english: false }))).toEqual([
    'an internal error occurred: unheard-of',
    'an internal error occurred: NotAllowedError',
  ]);
});
