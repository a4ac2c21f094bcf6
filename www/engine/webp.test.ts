import { expect, test } from 'vitest';
import { chunksOf, withDpi } from './webp.ts';

/** A file of one chunk of three bytes, as encoded by a browser. */
const PLAIN = Uint8Array.from(
  [...'RIFF', 16, 0, 0, 0, ...'WEBP', ...'VP8 ', 3, 0, 0, 0, 7, 8, 9, 0].map((part) =>
    typeof part === 'string' ? part.charCodeAt(0) : part,
  ),
);

test('the file says its dots an inch and has its picture as it was', async () => {
  const file = new Uint8Array(await withDpi(PLAIN, { width: 2480, height: 3508, dpi: 300 }).arrayBuffer());
  const view = new DataView(file.buffer);
  expect(view.getUint32(4, true)).toBe(file.length - 8);
  const chunks = chunksOf(file);
  expect(chunks.map(({ name }) => name)).toEqual(['VP8X', 'VP8 ', 'EXIF']);
  const [head, picture, exif] = chunks.map(({ data }) => data);
  expect([...head]).toEqual([0x08, 0, 0, 0, 0xaf, 0x09, 0, 0xb3, 0x0d, 0]);
  expect([...picture]).toEqual([7, 8, 9]);
  const about = new DataView(exif.buffer, exif.byteOffset);
  expect(String.fromCharCode(exif[0], exif[1])).toBe('II');
  expect([10, 22, 34].map((at) => about.getUint16(at, true))).toEqual([282, 283, 296]);
  expect([50, 54, 58, 62].map((at) => about.getUint32(at, true))).toEqual([300, 1, 300, 1]);
});

test('a second time there is still one EXIF chunk', async () => {
  const size = { width: 8, height: 8, dpi: 96 };
  const once = new Uint8Array(await withDpi(PLAIN, size).arrayBuffer());
  const twice = new Uint8Array(await withDpi(once, size).arrayBuffer());
  expect([...twice]).toEqual([...once]);
});
