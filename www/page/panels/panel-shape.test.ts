import { expect, test } from 'vitest';
import { neighbour } from './panel-shape.ts';

/** A row of two above one wide panel. */
const PANELS: any = [
  { bounds: { x: 0, y: 0, width: 0.5, height: 0.5 } },
  { bounds: { x: 0.5, y: 0, width: 0.5, height: 0.5 } },
  { bounds: { x: 0, y: 0.5, width: 1, height: 0.5 } },
];

test('arrows lead to the panel that lies there, and nowhere past the edge', () => {
  expect(neighbour(PANELS, 0, [1, 0])).toBe(1);
  expect(neighbour(PANELS, 1, [-1, 0])).toBe(0);
  expect(neighbour(PANELS, 0, [0, 1])).toBe(2);
  expect(neighbour(PANELS, 2, [0, 1])).toBe(2);
  expect(neighbour(PANELS, 0, [-1, 0])).toBe(0);
});
