import { expect, test } from 'vitest';
import { bmp } from './bmp.ts';

const RED = [255, 0, 0, 255];
const CLEAR = [0, 0, 0, 0];

test('a file has the pixels from top to bottom, in rows of four bytes, on white', () => {
  const file = bmp({ width: 1, height: 2, data: new Uint8Array([...RED, ...CLEAR]) });
  expect([...file.slice(0, 2)]).toEqual([0x42, 0x4d]);
  expect([...file.slice(54)]).toEqual([0, 0, 255, 0, 255, 255, 255, 0]);
});

test('a rotated picture is upright in the file', () => {
  const file = bmp({ width: 1, height: 2, data: new Uint8Array([...RED, ...CLEAR]), rotation: 90 });
  expect(new DataView(file.buffer).getInt32(18, true)).toBe(2);
  expect([...file.slice(54)]).toEqual([255, 255, 255, 0, 0, 255, 0, 0]);
});
