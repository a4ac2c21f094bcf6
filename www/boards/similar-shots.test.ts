import { expect, test } from 'vitest';
import { UNSPOKEN } from './shots.ts';
import { similarShots } from './similar-shots.ts';

test('shots that look like the one before are similar, unless they have text or a length', () => {
  const album: any = new Map(
    Object.entries({
      a: '0000000000000000',
      b: '0000000000000fff',
      c: '0000000000001fff',
      d: 'ffff000000000000',
      e: 'ffff000000000001',
      f: 'ffff000000000003',
      g: 'ffff000000000007',
    }).map(([id, fingerprint]) => [id, { meta: { fingerprint } }]),
  );
  const row = (id: string, more = {}) => ({ id, number: '', shot: {}, said: UNSPOKEN, ...more });
  const rows = [
    row('a'),
    row('b'),
    row('c'),
    row('d'),
    row('e', { shot: { frames: 12 } }),
    row('f', { said: { ...UNSPOKEN, sound: 'BANG' } }),
    row('g'),
    row('unread'),
  ];
  expect([...similarShots(rows, album)]).toEqual(['b', 'c', 'g']);
  expect([...similarShots([row('a'), row('d'), row('a')], album)]).toEqual([]);
});
