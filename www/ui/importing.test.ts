import { expect, test, vi } from 'vitest';
import { importing } from './importing.ts';

test('the result of an importer is passed on, and nothing is reported', async () => {
  const fileFailed = vi.fn();
  expect(await importing({ fileFailed }, 'a.csv', async () => 7)).toBe(7);
  expect(fileFailed).not.toHaveBeenCalled();
});

test('whatever an importer throws is reported with the name of the file and a reason', async () => {
  const fileFailed = vi.fn();
  const thrown = [
    new Error('it is empty.'),
    new TypeError('undefined is not a function'),
    Object.assign(new Error('raw'), { code: 'not-text' }),
    Object.assign(new Error('AVI'), { code: 'film-container' }),
    new DOMException('gone', 'NotFoundError'),
    'a string',
    null,
    undefined,
    Object.create(null),
  ];
  for (const error of thrown)
    expect(await importing({ fileFailed }, 'a.csv', () => Promise.reject(error))).toBeUndefined();
  expect(await importing({ fileFailed }, 'a.csv', () => JSON.parse('{'))).toBeUndefined();
  expect(fileFailed.mock.calls.map(([name]) => name)).toEqual(Array(thrown.length + 1).fill('a.csv'));
  expect(fileFailed.mock.calls.map(([, why]) => why)).toEqual([
    'it is empty.',
    'an internal error occurred: undefined is not a function',
    expect.stringMatching(/^it is not a text file/),
    expect.stringMatching(/^Inkpanel cannot read this video format \(AVI\)/),
    expect.stringMatching(/^the file was moved/),
    'an internal error occurred: a string',
    'an internal error occurred: [object Null]',
    'an internal error occurred: [object Undefined]',
    'an internal error occurred: [object Object]',
    expect.stringMatching(/^an internal error occurred: ./),
  ]);
});

test('cancelled work is not reported', async () => {
  const fileFailed = vi.fn();
  const cancelled = Object.assign(new Error('stopped'), { code: 'cancelled' });
  expect(await importing({ fileFailed }, 'a.csv', () => Promise.reject(cancelled))).toBeUndefined();
  expect(fileFailed).not.toHaveBeenCalled();
});

test('a caller gives its own reasons, its own sentence and a way on', async () => {
  const fileFailed = vi.fn();
  const way = { label: 'Use it', run: () => {} };
  const how = { reasons: { odd: 'it is odd' }, text: (why: string) => `Not opened: ${why}`, way };
  await importing({ fileFailed }, 'a.zip', () => Promise.reject(Object.assign(new Error('x'), { code: 'odd' })), how);
  expect(fileFailed).toHaveBeenCalledWith('a.zip', 'it is odd', { text: 'Not opened: it is odd', way });
});

test('a reason that names the file is the whole message', async () => {
  const fileFailed = vi.fn();
  await importing({ fileFailed }, 'a.json', () => Promise.reject(new Error('layout a.json: id: is missing')));
  expect(fileFailed.mock.calls[0][2].text).toBe('layout a.json: id: is missing');
});
