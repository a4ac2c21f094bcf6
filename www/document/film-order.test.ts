import { expect, test } from 'vitest';
import { inFilmOrder } from './album.ts';
import type { Fact } from './album.ts';

test('frames of a film come in the order of their times, in the places that they have', () => {
  const fact = (id: string, video?: string, time?: number): [string, Fact] => [
    id,
    { id, name: id, meta: null, measures: null, video, time },
  ];
  const album = new Map([
    fact('a', 'f', 5),
    fact('p'),
    fact('b', 'f', 1),
    fact('c', 'g', 9),
    fact('d', 'f', 3),
    fact('e', 'g', 2),
  ]);
  const items = ['a', 'p', 'b', 'c', 'd', 'e'].map((id) => ({ id }));
  expect(inFilmOrder(items, album).map(({ id }) => id)).toEqual(['b', 'p', 'd', 'e', 'a', 'c']);
  const ordered = ['b', 'p', 'd'].map((id) => ({ id }));
  expect(inFilmOrder(ordered, album)).toBe(ordered);
});
