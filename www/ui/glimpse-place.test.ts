import { expect, it } from 'vitest';
import { GAP, beside, inside as within } from './glimpse-place.ts';
import type { Box } from './glimpse-place.ts';

const WINDOW = { width: 1366, height: 768 };
const inside = ({ left, top, width, height }: Box, window = WINDOW) =>
  left >= GAP - 0.5 &&
  top >= GAP - 0.5 &&
  left + width <= window.width - GAP + 0.5 &&
  top + height <= window.height - GAP + 0.5;
const apart = (a: Box, b: Box) =>
  a.left >= b.left + b.width || b.left >= a.left + a.width || a.top >= b.top + b.height || b.top >= a.top + a.height;

it('lies beside a tile wherever that is, inside the window and not over it', () => {
  for (const window of [WINDOW, { width: 390, height: 844 }, { width: 844, height: 390 }]) {
    for (let left = 0; left + 150 <= window.width; left += 50) {
      for (let top = 0; top + 126 <= window.height; top += 40) {
        const at = { left, top, width: 150, height: 126 };
        const place = beside(at, { width: 440, height: 330 }, window);
        expect(inside(place, window), JSON.stringify([at, place])).toBe(true);
        expect(apart(place, at), JSON.stringify([at, place])).toBe(true);
        expect(place.width).toBeGreaterThan(150);
        expect(place.width / place.height).toBeCloseTo(440 / 330);
      }
    }
  }
});

it('covers what leaves it no room', () => {
  const window = { width: 320, height: 300 };
  const place = beside({ left: 60, top: 60, width: 200, height: 180 }, { width: 300, height: 400 }, window);
  expect(inside(place, window)).toBe(true);
  expect(place.height).toBeCloseTo(276);
});

it('lies inside of a room, at the edge that is next to what it belongs to', () => {
  const room = { left: 212, top: 48, width: 600, height: 700 };
  const size = { width: 300, height: 400 };
  const list = { left: 1100, top: 100, width: 120, height: 100 };
  expect(within(list, size, room)).toEqual({ left: 500, top: 60, ...size });
  const strip = { left: 20, top: 760, width: 80, height: 110 };
  expect(within(strip, size, room)).toEqual({ left: 224, top: 336, ...size });
  const low = within(strip, size, { ...room, height: 224 });
  expect([low.width, low.height]).toEqual([150, 200]);
});
