import { expect, test } from 'vitest';
import { thumbnail } from './cover.ts';
import type { Subject } from '../engine/types.ts';

const face = (x: number, y: number, side: number): Subject => ({
  x,
  y,
  width: side,
  height: side,
  label: 'face',
  score: 0.9,
});

test('a thumbnail shows the largest face of a photo, and stays inside of the photo', () => {
  const tall = { width: 600, height: 1200 };
  expect(thumbnail(tall, 100).crop).toEqual({ x: 0, y: 0.25, width: 1, height: 0.5 });
  const { crop } = thumbnail({ ...tall, subjects: [face(0.4, 0.7, 0.05), face(0.4, 0.3, 0.1)] }, 100);
  expect(crop.y).toBeCloseTo(0.1);
  expect(thumbnail({ ...tall, subjects: [face(0.4, 0, 0.1)] }, 100).crop.y).toBe(0);
  expect(thumbnail({ ...tall, subjects: [face(0.4, 0.9, 0.1)] }, 100).crop.y).toBe(0.5);
  // Other subjects may fill the photo.
  expect(thumbnail({ ...tall, subjects: [{ ...face(0.4, 0, 0.1), label: 'cat' }] }, 100).crop.y).toBe(0.25);
});
