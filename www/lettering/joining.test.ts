import { expect, test } from 'vitest';
import type { Word } from '../engine/types.ts';
import { balloonBefore, chainOf, hangsOn, joinedBefore, parted } from './joining.ts';

const balloon = (more: Partial<Word> = {}): Word => ({ kind: 'balloon', text: 'Hi', panel: 0, ...more });

test('a balloon hangs on the one that it names, by hand or by itself', () => {
  const words = [balloon({ id: 'a' }), balloon({ joined: 'a' }), balloon({ linked: 'a' }), balloon({ joined: 'b' })];
  expect(words.map((_, i) => hangsOn(words, i))).toEqual([-1, 0, 0, -1]);
  expect(hangsOn([balloon({ id: 'a', joined: 'a' })], 0)).toBe(-1);
});

test('a chain is found from each of its balloons', () => {
  const words = [
    balloon({ id: 'a' }),
    balloon(),
    balloon({ id: 'b', joined: 'a' }),
    balloon({ linked: 'b' }),
    balloon({ id: 'c' }),
  ];
  for (const one of [0, 2, 3]) expect(chainOf(words, one)).toEqual([0, 2, 3]);
  expect(chainOf(words, 1)).toEqual([1]);
});

test('the balloon before is the last on the same panel', () => {
  const words = [balloon(), balloon({ panel: 1 }), balloon({ kind: 'caption' }), balloon()];
  expect(words.map((_, i) => balloonBefore(words, i))).toEqual([-1, -1, -1, 0]);
});

test('joining names the balloon before, and parting keeps them apart', () => {
  const words = joinedBefore([balloon({ id: 'b1', panel: 1 }), balloon(), balloon({ apart: true, auto: false })], 2);
  expect(words[1].id).toBe('b2');
  expect(words[2]).toMatchObject({ joined: 'b2', apart: false, auto: true });
  expect(hangsOn(words, 2)).toBe(1);
  const apart = parted(words, 2);
  expect(hangsOn(apart, 2)).toBe(-1);
  expect(apart[2].apart).toBe(true);
  // The name already belongs to an earlier item, so the balloon gets another name.
  const twice = joinedBefore([balloon({ id: 'a', panel: 1 }), balloon({ id: 'a' }), balloon()], 2);
  expect(hangsOn(twice, 2)).toBe(1);
});
