import { expect, test } from 'vitest';
import { lipTimes, withMovement } from './lips.ts';
import type { Detection } from './types.ts';

function face(mouth?: number): Detection {
  const box = { label: 'face', score: 0.9, x: 0.1, y: 0.1, width: 0.2, height: 0.3 };
  return mouth === undefined ? box : { ...box, expression: { rightEye: 0.3, leftEye: 0.3, mouth, smile: 0.1 } };
}

test('frames lie around the photo and within the video', () => {
  expect(lipTimes({ time: 10, duration: 60 }).map((time) => time.toFixed(2))).toEqual([
    '9.55',
    '9.70',
    '9.85',
    '10.00',
    '10.15',
    '10.30',
    '10.45',
  ]);
  expect(lipTimes({ time: 0.2, duration: 0.4 })).toHaveLength(3);
});

test('a mouth that opens and closes moves more than one that stays open', () => {
  const looks = [0, 0.4, 0.1].map((mouth) => [face(mouth), face(0.5)]);
  const moved = withMovement([face(0.1), face(0.5)], looks) ?? [];
  expect(moved.map(({ expression }) => expression?.mouth)).toEqual([0.4, 0]);
  expect(moved[1]).toMatchObject({ x: 0.1, expression: { smile: 0.1 } });
});

test('without two readable frames of each face there is no result', () => {
  expect(
    withMovement(
      [face(0.1), face(0.5)],
      [
        [face(0.1), face()],
        [face(0.2), face(0.5)],
      ],
    ),
  ).toBeNull();
  expect(withMovement([face(0.1)], [])).toBeNull();
});
