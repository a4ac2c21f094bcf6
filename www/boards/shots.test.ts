import fc from 'fast-check';
import { expect, test } from 'vitest';
import { lengthOf, lengthText, numbered, ordered, withColumn, withField } from './shots.ts';

const MOST = 2_592_000;

test('lengths are read as people write them, and back as they are told', () => {
  const read = (text: string) => lengthOf(text, 25, MOST);
  expect(['2', '2,5', '36f', '1:12', '0:01:12', '0:00:01:12', ' 3 s '].map(read)).toEqual([50, 63, 36, 37, 37, 37, 75]);
  expect(['', '0', 'long', '-3', '1:x', '1:2:3:4:5'].map(read)).toEqual([
    null,
    undefined,
    undefined,
    undefined,
    undefined,
    undefined,
  ]);
  fc.assert(
    fc.property(fc.integer({ min: 1, max: MOST }), fc.constantFrom(24, 25, 30), (frames, fps) => {
      expect(lengthOf(lengthText(frames, fps), fps, MOST)).toBe(frames);
    }),
  );
});

test('photos that nobody put anywhere follow the one before them', () => {
  // The cases of `src/document/shots.rs`.
  const order = ['c', 'a', 'gone', 'c'];
  expect(ordered(order, ['a', 'b', 'c', 'd'])).toEqual(['c', 'd', 'a', 'b']);
  expect(ordered(order, ['x', 'a', 'c'])).toEqual(['x', 'c', 'a']);
  expect(ordered([], ['b', 'a'])).toEqual(['b', 'a']);
});

test('numbers are counted past those of ones own', () => {
  const rows = ['', '', '2A', ' ', '9'].map((number, i) => ({ id: String(i), shot: { number } }));
  expect(numbered(rows).map(({ number }) => number)).toEqual(['1', '2', '2A', '3', '9']);
});

test('what is empty is not told', () => {
  expect(withField({ scene: '1', notes: 'x' }, 'notes', '')).toEqual({ scene: '1' });
  expect(withColumn({ more: { Lens: '35' } }, 'Lens', '')).toEqual({});
  expect(withColumn({}, 'Lens', '35')).toEqual({ more: { Lens: '35' } });
});
