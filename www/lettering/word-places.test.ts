import { expect, test } from 'vitest';
import { anchored, frameOf, pagePoint } from './word-places.ts';

const bounds = (x: number, y: number) => ({ bounds: { x, y, width: 0.4, height: 0.5 }, overlay: false, halo: 0 });
const geometry = {
  width: 1,
  height: 1.4,
  panels: [bounds(0.05, 0.1), bounds(0.55, 0.1), bounds(0.3, 0.3)],
  order: [0, 1, 2],
};
const word = { kind: 'balloon', text: 'x', panel: 0 } as const;

test('a place of a panel is one of the page and back', () => {
  expect(pagePoint(geometry, { panel: 1 }, [0.5, 0.5])).toEqual([0.75, 0.35]);
  const { panel, x, y, tail } = anchored(geometry, word, [0.85, 0.35], [0.75, 0.6]);
  expect([panel, x, y, tail]).toEqual([1, 0.75, 0.5, { x: 0.5, y: 1 }]);
});

test('the uppermost panel takes a word; one in a gutter stays with its own; none goes beyond the page', () => {
  expect(anchored(geometry, word, [0.4, 0.4], null).panel).toBe(2);
  expect(anchored(geometry, word, [0.5, 0.1], null).panel).toBe(0);
  const beyond = anchored(geometry, { ...word, panel: null }, [-1, 9], null);
  expect([beyond.panel, beyond.x, beyond.y]).toEqual([null, 0, 1]);
});

test('a panel that is gone is the last, and none is the page', () => {
  expect(frameOf(geometry, { panel: 9 })).toEqual(geometry.panels[2].bounds);
  expect(frameOf(geometry, {})).toEqual({ x: 0, y: 0, width: 1, height: 1.4 });
});
