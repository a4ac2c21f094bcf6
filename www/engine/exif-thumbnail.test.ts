import { expect, test } from 'vitest';
import { findThumbnail } from './exif-thumbnail.ts';

/** A JPEG file with an orientation in the first directory and a thumbnail in the second. */
function file({ little = true, orientation = 6, length = 5 } = {}) {
  const bytes = new Uint8Array(100);
  const view = new DataView(bytes.buffer);
  view.setUint16(0, 0xffd8);
  // Another segment precedes EXIF.
  view.setUint32(2, 0xffe00004);
  view.setUint16(8, 0xffe1);
  view.setUint16(10, 80);
  view.setUint32(12, 0x45786966);
  const tiff = 18;
  const set16 = (at: number, value: number) => view.setUint16(tiff + at, value, little);
  const set32 = (at: number, value: number) => view.setUint32(tiff + at, value, little);
  view.setUint16(tiff, little ? 0x4949 : 0x4d4d);
  set32(4, 8);
  set16(8, 1);
  for (const [at, tag, type, value] of [
    [10, 0x0112, 3, orientation],
    [28, 0x0201, 4, 56],
    [40, 0x0202, 4, length],
  ]) {
    set16(at, tag);
    set16(at + 2, type);
    set32(at + 4, 1);
    if (type === 3) set16(at + 8, value);
    else set32(at + 8, value);
  }
  set32(22, 26);
  set16(26, 2);
  return view;
}

test('a thumbnail is found in both byte orders, with its orientation', () => {
  for (const little of [true, false]) expect(findThumbnail(file({ little }))).toEqual({ start: 74, end: 79, turn: 1 });
  expect(findThumbnail(file({ orientation: 3 }))?.turn).toBe(2);
  expect(findThumbnail(file({ orientation: 99 }))?.turn).toBe(0);
});

test('a thumbnail outside its segment, and a file without metadata, have none', () => {
  expect(findThumbnail(file({ length: 500 }))).toBeNull();
  expect(findThumbnail(new DataView(new Uint8Array([0xff, 0xd8, 0xff, 0xda, 0, 2]).buffer))).toBeNull();
  expect(findThumbnail(new DataView(new Uint8Array([0x89, 0x50, 0x4e, 0x47]).buffer))).toBeNull();
});

test('truncated metadata is an error', () => {
  const whole = file();
  expect(() => findThumbnail(new DataView(whole.buffer, 0, 40))).toThrow(RangeError);
});
