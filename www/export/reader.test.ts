/** Tests the calculations of the reader of an HTML comic. Browser tests check its look and its text. */

import { describe, expect, test } from 'vitest';
import { boxOf, fitted, placeOf, stepped, swiped } from '../../crates/engine/src/output/reader/reader.js';

test('a part of a page fills the screen, in its middle', () => {
  const box = boxOf('100 200 400 100');
  expect(box).toEqual({ x: 100, y: 200, width: 400, height: 100 });
  const { scale, x, y } = fitted(box, { width: 820, height: 600 }, 10);
  expect(scale).toBe(2);
  expect([x + 100 * scale, y + 200 * scale]).toEqual([10, 200]);
  // A part that is high fits by its height.
  expect(fitted({ x: 0, y: 0, width: 10, height: 100 }, { width: 820, height: 600 }, 10).scale).toBe(5.8);
});

test('a finger turns the page when it goes across', () => {
  const at = (x: number, y: number) => ({ x, y });
  expect(swiped(at(200, 100), at(120, 110))).toBe(1);
  expect(swiped(at(100, 100), at(180, 90))).toBe(-1);
  expect(swiped(at(100, 100), at(130, 100))).toBe(0);
  expect(swiped(at(100, 100), at(160, 170))).toBe(0);
});

describe('reading goes', () => {
  const panels = [2, 3];
  const walk = (view: 'panels' | 'pages', by: 1 | -1, from: { page: number; panel: number }) => {
    const seen = [];
    for (let at = stepped(from, by, panels, view); at; at = stepped(at, by, panels, view))
      seen.push([at.page, at.panel]);
    return seen;
  };

  test('through every panel in order, and back', () => {
    expect(walk('panels', 1, { page: 0, panel: 0 })).toEqual([
      [0, 1],
      [1, 0],
      [1, 1],
      [1, 2],
    ]);
    expect(walk('panels', -1, { page: 1, panel: 2 })).toEqual([
      [1, 1],
      [1, 0],
      [0, 1],
      [0, 0],
    ]);
  });

  test('through pages', () => {
    expect(walk('pages', 1, { page: 0, panel: 1 })).toEqual([[1, 0]]);
    expect(walk('pages', -1, { page: 1, panel: 2 })).toEqual([[0, 0]]);
  });
});

test('an address says where one is, unless there is no such place', () => {
  expect(placeOf('#page-2-panel-3', [2, 3])).toEqual({ page: 1, panel: 2 });
  expect(placeOf('#page-2', [2, 3])).toEqual({ page: 1, panel: 0 });
  for (const wrong of ['', '#page-3', '#page-2-panel-4', '#page-0-panel-1', '#elsewhere'])
    expect(placeOf(wrong, [2, 3])).toBe(null);
});
