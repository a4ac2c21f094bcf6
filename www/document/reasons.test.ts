import { expect, test } from 'vitest';
import { reasonsOf } from './album.ts';
import type { Fact, Verdict } from './album.ts';

test('the reason of a photo is the one of the selection, the used photo of its group, or the choice of the user', () => {
  const fact = (id: string): [string, Fact] => [id, { id, name: `${id}.jpg`, meta: null, measures: null }];
  const album = new Map(['a', 'b', 'c', 'd'].map(fact));
  const verdict = (id: string, group: number, kept: boolean, reason: Verdict['reason']): [string, Verdict] => [
    id,
    { id, group, kept, why: '', reason },
  ];
  const verdicts = new Map([
    verdict('a', 0, true, { code: 'sharpest', of: 2 }),
    verdict('b', 0, false, { code: 'same-as', name: 'a.jpg' }),
    verdict('c', 1, true, { code: 'only' }),
    verdict('d', 2, false, { code: 'blurred' }),
  ]);
  const reasons = (uses: Record<string, boolean>) =>
    Object.fromEntries(
      reasonsOf(
        ['a', 'b', 'c', 'd'].map((id) => ({ id, use: uses[id] })),
        album,
        verdicts,
      ),
    );
  expect(reasons({})).toEqual({
    a: { code: 'sharpest', of: 2 },
    b: { code: 'same-as', name: 'a.jpg' },
    c: { code: 'only' },
    d: { code: 'blurred' },
  });
  // A better page exchanged both, and the user changed the others.
  expect(reasons({ a: false, b: true, c: false, d: true })).toEqual({ a: { code: 'same-as', name: 'b.jpg' } });
  expect(reasons({ a: false })).not.toHaveProperty('a');
});
