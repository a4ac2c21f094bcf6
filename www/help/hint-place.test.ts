import { expect, it } from 'vitest';
import { placeHint } from './hint-place.ts';
import type { Box } from './hint-place.ts';

const ROOM = { left: 0, top: 0, width: 1000, height: 800 };
const SIZE = { width: 200, height: 50 };
const ANCHOR = { left: 400, top: 600, width: 100, height: 40 };
const FREE = { controls: [] as Box[], messages: [] as Box[] };

it('stands on the best side, centred, and points at what it is about', () => {
  expect(placeHint(ANCHOR, SIZE, ROOM, FREE, ['above', 'below'])).toEqual({ x: 350, y: 538, side: 'above', tail: 100 });
  expect(placeHint(ANCHOR, SIZE, ROOM, FREE, ['after'])).toEqual({ x: 512, y: 595, side: 'after', tail: 25 });
});

it('is shifted within the window, or goes to another side', () => {
  const corner = { left: 0, top: 4, width: 40, height: 40 };
  expect(placeHint(corner, SIZE, ROOM, FREE, ['above', 'below'])).toEqual({ x: 8, y: 56, side: 'below', tail: 20 });
});

it('touches no control, beside it if that helps, else farther away and without a tail', () => {
  const control = { left: 350, top: 550, width: 20, height: 20 };
  const beside = placeHint(ANCHOR, SIZE, ROOM, { ...FREE, controls: [control] }, ['above']);
  expect(beside).toEqual({ x: 400, y: 538, side: 'above', tail: 50 });
  const row = Array.from({ length: 100 }, (_, i) => ({ left: i * 10, top: 560, width: 8, height: 8 }));
  expect(placeHint(ANCHOR, SIZE, ROOM, { ...FREE, controls: row }, ['above'])).toEqual({
    x: 350,
    y: 486,
    side: 'above',
    tail: null,
  });
});

it('lies at least over the middle of none, where there is no room for more', () => {
  const wide = { left: 0, top: 500, width: 760, height: 20 };
  const low = { ...ROOM, top: 520, height: 280 };
  expect(placeHint(ANCHOR, SIZE, low, { ...FREE, controls: [{ ...wide, top: 560 }] }, ['above'])).toMatchObject({
    x: 400,
  });
  const full = Array.from({ length: 100 }, (_, i) => ({ left: i * 10, top: 560, width: 8, height: 8 }));
  const place = placeHint(ANCHOR, SIZE, low, { ...FREE, controls: full }, ['above']);
  expect(place?.tail).toBeNull();
  expect(place?.y).toBeGreaterThan(564);
});

it('is over the foot of what it is about where that fills the room', () => {
  const all = { ...ROOM, left: 10, width: 980 };
  const place = placeHint(all, SIZE, ROOM, { ...FREE, controls: [all] }, ['above', 'below', 'after', 'before']);
  expect(place?.tail).toBeNull();
  expect(Math.abs((place?.x ?? 0) + 100 - 500)).toBeLessThan(20);
  expect(place?.y).toBeGreaterThan(700);
});

it('touches no message, and stands nowhere where there is no room', () => {
  const message = { left: 0, top: 500, width: 1000, height: 90 };
  expect(placeHint(ANCHOR, SIZE, ROOM, { ...FREE, messages: [message] }, ['above'])).toMatchObject({
    y: 434,
    tail: null,
  });
  expect(placeHint(ANCHOR, SIZE, { ...ROOM, width: 150 }, FREE, ['above'])).toBeNull();
});
