import { expect, test } from 'vitest';
import { estimated, extrapolated, spread } from './estimate.ts';

const page = (width: number) => ({ page: { width, height: width * 2 } }) as any;

test('bytes grow with the pixels as they did between the small sizes, and never faster than the pixels', () => {
  expect(
    extrapolated(
      [
        { bytes: 100, pixels: 100 },
        { bytes: 200, pixels: 400 },
      ],
      1600,
    ),
  ).toBeCloseTo(400);
  expect(
    extrapolated(
      [
        { bytes: 100, pixels: 100 },
        { bytes: 400, pixels: 400 },
      ],
      1600,
    ),
  ).toBeCloseTo(1600);
  expect(
    extrapolated(
      [
        { bytes: 100, pixels: 100 },
        { bytes: 900, pixels: 400 },
      ],
      1600,
    ),
  ).toBeCloseTo(3600);
  expect(
    extrapolated(
      [
        { bytes: 100, pixels: 100 },
        { bytes: 100, pixels: 100 },
      ],
      400,
    ),
  ).toBeCloseTo(400);
});

test('a few pages stand for many', async () => {
  const asked: number[] = [];
  const measureFile = async (document: any, { width }: { width: number }) => {
    asked.push(document.page.width);
    return { bytes: width * width * 2, pixels: width * width * 2 };
  };
  const pages = [800, 1600, 1600, 1600, 800].map(page);
  const bytes = await estimated({ measureFile }, pages, { format: 'png', quality: 90 });
  expect(new Set(asked).size).toBe(2);
  expect(asked).toHaveLength(6);
  expect(bytes).toBeCloseTo((5 * (2 * 800 * 800 * 2 + 1600 * 1600 * 2)) / 3);
});

test('the first and the last are among the few', () => {
  expect(spread([1, 2, 3, 4, 5, 6], 3)).toEqual([1, 4, 6]);
  expect(spread([1, 2], 3)).toEqual([1, 2]);
});
