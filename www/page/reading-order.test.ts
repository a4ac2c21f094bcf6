import { expect, test } from 'vitest';
import { core } from '../engine/testing-core.ts';
import { readingOrder } from './reading-order.ts';
import type { PageDocument } from '../engine/types.ts';

const page = (layout: string, merges: number[][] = []) =>
  ({
    layout,
    merges,
    page: { width: 2480, height: 3508, dpi: 300 },
    panels: Array.from({ length: 5 }, () => ({ photo: null })),
  }) as unknown as PageDocument;

test('an inset in the middle is read in the middle, and merged panels once', () => {
  expect(readingOrder(page('inset-middle-4'), core)).toEqual([0, 1, 4, 2, 3]);
  expect(readingOrder(page('inset-middle-4', [[0, 1]]), core)).toEqual([0, 4, 2, 3]);
  expect(readingOrder(page('inset-middle-4'), null)).toEqual([0, 1, 2, 3, 4]);
});
