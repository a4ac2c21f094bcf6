import { expect, test } from 'vitest';
import { unitsOf } from './word-units.ts';

test('print has millimetres and points, screens have pixels', () => {
  const a4 = unitsOf({ width: 2480, dpi: 300 });
  expect([a4.length.unit, Math.round(a4.length.per)]).toEqual(['mm', 210]);
  // 10 points are 1.68 % of the width.
  expect([a4.text.unit, Math.round(0.0168 * a4.text.per)]).toEqual(['pt', 10]);
  expect(unitsOf({ width: 1440, dpi: 96 })).toEqual({
    length: { unit: 'px', per: 1440, digits: 0 },
    text: { unit: 'px', per: 1440, digits: 0 },
  });
});
