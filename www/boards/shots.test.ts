import fc from 'fast-check';
import { expect, test } from 'vitest';
import { lengthOf, lengthText, numbered, ordered, RATES, rateName, withColumn, withField } from './shots.ts';

const MOST = 2_592_000;

test('lengths are read as people write them, and back as they are told', () => {
  const read = (text: string) => lengthOf(text, { fps: 25 }, MOST);
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
    fc.property(fc.integer({ min: 1, max: MOST }), fc.constantFrom(...Object.values(RATES)), (frames, rate) => {
      expect(lengthOf(lengthText(frames, rate), rate, MOST)).toBe(frames);
    }),
  );
});

test('lengths have units', () => {
  expect([48, 60, 12, 1596, 1440].map((frames) => lengthText(frames, { fps: 24 }))).toEqual([
    '2 s',
    '2 s 12 f',
    '12 f',
    '1 min 6 s 12 f',
    '1 min',
  ]);
});

test('at 29.97 DF lengths are told as time codes that leave numbers out', () => {
  // The cases of `crates/model/src/timecode.rs`.
  const drop = RATES['29.97 DF'];
  const told = [1_799, 1_800, 3_598, 17_982, 19_782].map((frames) => lengthText(frames, drop));
  expect(told).toEqual(['0:59;29', '1:00;02', '2:00;02', '10:00;00', '11:00;02']);
  expect(lengthOf('60', drop, MOST)).toBe(1798);
  expect(Object.values(RATES).map(rateName)).toEqual(Object.keys(RATES));
});

test('photos that nobody put anywhere follow the one before them', () => {
  // The cases of `crates/model/src/shots.rs`.
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
