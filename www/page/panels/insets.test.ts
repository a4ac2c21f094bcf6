import { expect, test } from 'vitest';
import { withHoles, wholePhoto } from './crop-ghost.tsx';
import { dragged } from './insets.tsx';

const LIMITS = { x: 0.05, y: 0.05, width: 0.9, height: 1.3 };
const BOUNDS = { x: 0.4, y: 0.4, width: 0.3, height: 0.2 };

const right = ({ x, width }: { x: number; width: number }) => x + width;
const bottom = ({ y, height }: { y: number; height: number }) => y + height;

test('an inset moves as a whole, and a corner leaves the opposite corner in place', () => {
  expect(dragged(BOUNDS, 'all', [0.1, -0.1], LIMITS, false)).toMatchObject({ width: 0.3, height: 0.2, x: 0.5 });
  const grown = dragged(BOUNDS, [-1, 1], [-0.1, 0.1], LIMITS, false);
  expect(right(grown)).toBeCloseTo(0.7);
  expect(grown.y).toBe(0.4);
  expect([grown.width, grown.height].map((side) => side.toFixed(3))).toEqual(['0.400', '0.300']);
});

test('no corner leaves the margins, and a circle stays one', () => {
  const wide = dragged(BOUNDS, [1, 1], [5, 5], LIMITS, false);
  expect(right(wide)).toBeCloseTo(0.95);
  expect(bottom(wide)).toBeCloseTo(1.35);
  const round = dragged({ ...BOUNDS, height: 0.3 }, [-1, -1], [-5, 0], LIMITS, true);
  expect(round.width).toBeCloseTo(round.height);
  expect(round.x).toBeGreaterThanOrEqual(0.05 - 1e-9);
  expect(round.y).toBeGreaterThanOrEqual(0.05 - 1e-9);
  // A corner that is dragged past the opposite one leaves a small inset.
  expect(dragged(BOUNDS, [1, 1], [-2, -2], LIMITS, false).width).toBeGreaterThan(0);
});

test('the whole photo lies around the part that its panel shows', () => {
  const whole = wholePhoto({ x: 0.5, y: 0.5, width: 0.2, height: 0.1 }, { x: 0.25, y: 0.5, width: 0.5, height: 0.25 });
  expect([whole.x, whole.y, whole.width, whole.height].map((one) => one.toFixed(3))).toEqual([
    '0.400',
    '0.300',
    '0.400',
    '0.400',
  ]);
});

test('a clip path goes around each hole and returns', () => {
  expect(withHoles([['1% 1%', '2% 2%']])).toBe(
    'polygon(evenodd, 0 0, 100% 0, 100% 100%, 0 100%, 0 0, 1% 1%, 2% 2%, 1% 1%, 0 0)',
  );
});
